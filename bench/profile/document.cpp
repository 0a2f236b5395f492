#include "document.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace gsbench::profile {
namespace {

Position position_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value convert(const toml::node& node);

Array convert_array(const toml::array& array) {
  Array items;
  items.reserve(array.size());
  for (const toml::node& item : array) items.push_back(convert(item));
  return items;
}

Entries convert_table(const toml::table& table) {
  Entries entries;
  entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    entries.push_back({std::string(key.str()), position_of(key.source()), convert(node)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column);
  });
  return entries;
}

Value convert(const toml::node& node) {
  Value value;
  value.at = position_of(node.source());
  if (const auto* table = node.as_table()) {
    value.data = convert_table(*table);
  } else if (const auto* array = node.as_array()) {
    value.data = convert_array(*array);
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* real = node.as_floating_point()) {
    value.data = real->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.data = boolean->get();
  } else {
    value.data = DateOrTime{};
  }
  return value;
}

struct Describe {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  // With a decimal point, so that 8000.0 does not read like the whole number it should have been.
  std::string operator()(double value) const {
    const std::string digits = fmt::format("{}", value);
    return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0" : digits;
  }
  std::string operator()(const std::string& value) const {
    return fmt::format("the text \"{}\"", value);
  }
  std::string operator()(DateOrTime) const { return "a date or time"; }
  std::string operator()(const Array&) const { return "an array"; }
  std::string operator()(const Entries&) const { return "a table"; }
};

}  // namespace

Document parse_toml(const std::string& text, const std::string& path) {
  try {
    return {path, convert(toml::parse(text))};
  } catch (const toml::parse_error& error) {
    throw error_at(path, position_of(error.source()),
                   fmt::format("not well-formed TOML: {}", error.description()));
  }
}

ConfigurationError error_at(const std::string& path, Position at, const std::string& message) {
  return ConfigurationError(fmt::format("{}:{}:{}: {}", path, at.line, at.column, message));
}

std::string describe(const Value& value) {
  return std::visit(Describe{}, value.data);
}

}  // namespace gsbench::profile
