#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Error;
using drivers::Result;

namespace {

std::string trimmed(const std::string& text) {
  const char* const kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string unquoted(const std::string& text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? text.substr(1, text.size() - 2) : text;
}

// "C1:BSWV WVTP,ARB" without "C1:BSWV ": the header has no comma and ends at the first blank.
std::string without_header(const std::string& answer) {
  const std::size_t blank = answer.find(' ');
  const std::size_t comma = answer.find(',');
  return blank != std::string::npos && (comma == std::string::npos || blank < comma)
             ? answer.substr(blank + 1)
             : answer;
}

}  // namespace

std::string number_text(double value) {
  return fmt::format("{:.10g}", value);
}

std::string filled(const std::string& text, const Values& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '{' ? text.find('}', at) : std::string::npos;
    const auto known = end == std::string::npos
                           ? values.end()
                           : std::find_if(values.begin(), values.end(), [&](const auto& value) {
                               return text.compare(at + 1, end - at - 1, value.first) == 0;
                             });
    if (known == values.end()) {
      result += text[at++];
    } else {
      result += known->second;
      at = end + 1;
    }
  }
  return result;
}

std::vector<std::string> placeholders(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    const std::size_t end = text.find('}', at);
    names.push_back(text.substr(at + 1, end == std::string::npos ? end : end - at - 1));
  }
  return names;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, at)) {
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  parts.push_back(text.substr(at));
  return parts;
}

Result<std::string> value_in(const std::string& answer, const std::string& field) {
  if (field.empty()) {
    return unquoted(trimmed(answer));
  }
  const std::vector<std::string> items = split(without_header(trimmed(answer)), ',');
  const bool counted =
      std::all_of(field.begin(), field.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (counted) {
    const auto item = static_cast<std::size_t>(std::stoul(field));
    if (item >= 1 && item <= items.size()) {
      return unquoted(trimmed(items[item - 1]));
    }
  } else {
    for (std::size_t i = 0; i + 1 < items.size(); ++i) {
      if (equal_ignoring_case(trimmed(items[i]), field)) {
        return unquoted(trimmed(items[i + 1]));
      }
    }
  }
  return Error{fmt::format("\"{}\" has no item {}", printable(answer), field)};
}

Result<double> number_in(const std::string& text, const std::string& unit) {
  // from_chars takes no leading plus sign.
  const char* const first = text.data() + (!text.empty() && text.front() == '+' ? 1 : 0);
  const char* const last = text.data() + text.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc()) {
    return Error{fmt::format("\"{}\" is not a number", printable(text))};
  }
  const std::string rest = trimmed({end, last});
  if (!rest.empty() && !equal_ignoring_case(rest, unit)) {
    return Error{fmt::format("\"{}\" has the unit \"{}\" instead of \"{}\"", printable(text),
                             printable(rest), unit)};
  }
  return value;
}

bool equal_ignoring_case(const std::string& a, const std::string& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](unsigned char x, unsigned char y) {
           return std::toupper(x) == std::toupper(y);
         });
}

bool is_one_of(const std::string& text, const std::string& alternatives) {
  const std::vector<std::string> all = split(alternatives, '|');
  return std::any_of(all.begin(), all.end(), [&](const std::string& alternative) {
    return equal_ignoring_case(text, alternative);
  });
}

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    result += std::isprint(byte) != 0 ? std::string(1, c) : fmt::format("\\x{:02X}", byte);
    if (result.size() > kLongest) {
      return result.substr(0, kLongest) + "…";
    }
  }
  return result;
}

}  // namespace gsbench::scpi
