// Texts: forms of names, numbers, headers.
#include "generator_scpi.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace gsbench::emulation {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The size of the short form: the upper-case letters in front.
std::size_t short_size(std::string_view name) {
  return static_cast<std::size_t>(
      std::find_if(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; }) -
      name.begin());
}

std::string_view without_channel(std::string_view node) {
  if (node.size() > 1 && node.back() == '1') {
    node.remove_suffix(1);
  }
  return node;
}

bool node_matches(std::string_view node, std::string_view name) {
  return is_form_of(node, name) || is_form_of(without_channel(node), name);
}

struct Node {
  std::string_view name;
  bool optional;
};

// Of "[SOURce:]FREQuency[:CW]": SOURce and CW are optional.
std::vector<Node> nodes_of(std::string_view pattern) {
  std::vector<Node> nodes;
  bool optional = false;
  while (!pattern.empty()) {
    const std::size_t end = std::min(pattern.find_first_of(":[]"), pattern.size());
    if (end > 0) {
      nodes.push_back({pattern.substr(0, end), optional});
    }
    if (end < pattern.size() && pattern[end] != ':') {
      optional = pattern[end] == '[';
    }
    pattern.remove_prefix(std::min(end + 1, pattern.size()));
  }
  return nodes;
}

bool nodes_match(const std::vector<Node>& header, std::size_t at, const std::vector<Node>& pattern,
                 std::size_t in_pattern) {
  if (in_pattern == pattern.size()) {
    return at == header.size();
  }
  const Node& node = pattern[in_pattern];
  return (at < header.size() && node_matches(header[at].name, node.name) &&
          nodes_match(header, at + 1, pattern, in_pattern + 1)) ||
         (node.optional && nodes_match(header, at, pattern, in_pattern + 1));
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return result;
}

std::string_view left_trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  text = left_trimmed(text);
  while (!text.empty() && is_space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::vector<std::string_view> fields_of(std::string_view text) {
  std::vector<std::string_view> fields;
  if (trimmed(text).empty()) {
    return fields;
  }
  char quote = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote != 0) {
      quote = text[i] == quote ? char{0} : quote;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == ',') {
      fields.push_back(trimmed(text.substr(start, i - start)));
      start = i + 1;
    }
  }
  fields.push_back(trimmed(text.substr(start)));
  return fields;
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

std::optional<double> number_of(std::string_view text) {
  const std::string all = upper(trimmed(text));
  if (is_form_of(all, "INFinity")) {
    return std::numeric_limits<double>::infinity();
  }
  // strtod() would also read names and hexadecimal numbers.
  if (all.empty() || !(is_digit(all[0]) || all[0] == '-' || all[0] == '+' || all[0] == '.') ||
      all.find('X') != std::string::npos) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double number = std::strtod(all.c_str(), &end);
  if (end == all.c_str() || !std::isfinite(number)) {
    return std::nullopt;
  }
  std::string_view unit = trimmed(std::string_view(end));
  bool mega = false;
  for (const std::string_view known :
       {"HZ", "SA/S", "OHM", "VPP", "VRMS", "VDC", "DEG", "PCT", "%", "V", "S"}) {
    if (ends_with(unit, known)) {
      mega = known == "HZ" || known == "SA/S" || known == "OHM";
      unit.remove_suffix(known.size());
      break;
    }
  }
  if (unit.empty()) {
    return number;
  }
  if (unit.size() > 1) {
    return std::nullopt;
  }
  switch (unit[0]) {
    case 'G':
      return number * 1e9;
    case 'K':
      return number * 1e3;
    case 'M':
      return number * (mega ? 1e6 : 1e-3);
    case 'U':
      return number * 1e-6;
    case 'N':
      return number * 1e-9;
    default:
      return std::nullopt;
  }
}

std::optional<bool> switch_of(std::string_view text) {
  const std::string value = upper(trimmed(text));
  if (value == "ON" || value == "1") {
    return true;
  }
  if (value == "OFF" || value == "0") {
    return false;
  }
  return std::nullopt;
}

bool is_form_of(std::string_view text, std::string_view name) {
  const std::string form = upper(text);
  return form == upper(name) || form == name.substr(0, short_size(name));
}

bool matches(std::string_view header, std::string_view pattern) {
  return nodes_match(nodes_of(header), 0, nodes_of(pattern), 0);
}

}  // namespace gsbench::emulation
