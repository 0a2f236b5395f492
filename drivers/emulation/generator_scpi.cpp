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
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// The size of the block that starts at `at`, with its header: 0 if none starts there; npos if it
// is not complete.
std::size_t block_size(std::string_view text, std::size_t at) {
  if (text[at] != '#') {
    return 0;
  }
  if (at + 1 == text.size()) {
    return std::string_view::npos;
  }
  const char digits = text[at + 1];
  if (digits < '1' || digits > '9') {
    return 0;
  }
  std::size_t length = 0;
  const std::size_t start = at + 2 + static_cast<std::size_t>(digits - '0');
  for (std::size_t i = at + 2; i < start; ++i) {
    if (i == text.size()) {
      return std::string_view::npos;
    }
    if (!is_digit(text[i])) {
      return 0;
    }
    length = length * 10 + static_cast<std::size_t>(text[i] - '0');
  }
  return start + length > text.size() ? std::string_view::npos : start + length - at;
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

std::vector<ScpiUnit> units_of(std::string_view message) {
  std::vector<ScpiUnit> units;
  std::string path;  // of the header before, without its last node
  std::size_t start = 0;
  std::size_t block_end = 0;  // bytes of a block are no white space
  char quote = 0;
  for (std::size_t i = 0; i <= message.size(); ++i) {
    if (i < message.size()) {
      const char c = message[i];
      if (quote != 0) {
        quote = c == quote ? char{0} : quote;
        continue;
      }
      if (c == '"' || c == '\'') {
        quote = c;
        continue;
      }
      if (const std::size_t block = block_size(message, i);
          block != 0 && block != std::string_view::npos) {
        block_end = i + block;
        i = block_end - 1;
        continue;
      }
      if (c != ';') {
        continue;
      }
    }
    std::size_t end = i;
    while (end > std::max(start, block_end) && is_space(message[end - 1])) {
      --end;
    }
    const std::string_view text = left_trimmed(message.substr(start, end - start));
    start = i + 1;
    if (text.empty()) {
      continue;
    }
    ScpiUnit unit;
    const auto space = std::find_if(text.begin(), text.end(), is_space) - text.begin();
    std::string header = upper(text.substr(0, static_cast<std::size_t>(space)));
    unit.argument = left_trimmed(text.substr(static_cast<std::size_t>(space)));
    if (header.back() == '?') {
      unit.query = true;
      header.pop_back();
    }
    if (!header.empty() && header.front() == ':') {
      header.erase(0, 1);
      path.clear();
    } else if (header.empty() || header.front() != '*') {
      header = path + header;
    }
    if (header.empty() || header.front() != '*') {
      const auto last = header.rfind(':');
      path = last == std::string::npos ? "" : header.substr(0, last + 1);
    }
    unit.header = std::move(header);
    units.push_back(std::move(unit));
  }
  return units;
}

std::optional<std::string_view> block_of(std::string_view text) {
  if (text.empty()) {
    return std::nullopt;
  }
  const std::size_t size = block_size(text, 0);
  if (size == 0 || size == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t header = 2 + static_cast<std::size_t>(text[1] - '0');
  return text.substr(header, size - header);
}

std::size_t ScpiFraming::message_size(std::string_view bytes) {
  in_block_ = false;
  for (; scanned_ < bytes.size(); ++scanned_) {
    const char c = bytes[scanned_];
    if (c == '\n') {
      const std::size_t size = scanned_ + 1;
      forget();
      return size;
    }
    if (quote_ != 0) {
      quote_ = c == quote_ ? char{0} : quote_;
    } else if (c == '"' || c == '\'') {
      quote_ = c;
    } else if (const std::size_t block = block_size(bytes, scanned_); block != 0) {
      if (block == std::string_view::npos) {
        in_block_ = true;
        return 0;
      }
      scanned_ += block - 1;
    }
  }
  return 0;
}

void ScpiErrors::add(int number, std::string_view text) {
  if (errors_.size() < longest_) {
    errors_.emplace_back(number, text);
  } else {
    errors_.back() = {-350, "Queue overflow"};
  }
}

std::string ScpiErrors::next() {
  if (errors_.empty()) {
    return signs_ ? "+0,\"No error\"" : "0,\"No error\"";
  }
  const auto [number, text] = errors_.front();
  errors_.pop_front();
  return (signs_ && number > 0 ? "+" : "") + std::to_string(number) + ",\"" + text + "\"";
}

}  // namespace gsbench::emulation
