#include "sections.hpp"

#include <fmt/format.h>

#include <outlet/settings.hpp>

namespace gsbench::profile {
namespace {

using gs::outlet::Field;
using gs::outlet::FieldType;
using gs::outlet::kSettingsFields;
using keys::Key;
using keys::Range;
using keys::Table;

// The shortest decimal number that is this float: 0.1f gives 0.1.
double decimal(float value) {
  return std::stod(fmt::format("{}", value));
}

Range range_of(const Field& field, double nominal_hz) {
  const double scale = field.range.of_nominal ? nominal_hz : 1.0;
  return {decimal(field.range.least) * scale, decimal(field.range.most) * scale,
          field.range.without_least, field.range.without_most,
          field.range.of_nominal ? "the grid's nominal_hz" : ""};
}

Key key_of(const Field& field) {
  const Range range = range_of(field, 1.0);
  const Key key =
      field.type != FieldType::kFloat
          ? keys::whole(field.name, field.unit, range.low, range.high, field.meaning)
      : field.range.of_nominal
          ? keys::number(field.name, field.unit, keys::above(0.0), field.meaning)
                .permits(fmt::format("{} × nominal ≤ value ≤ nominal, after rounding to float",
                                     range.low))
          : keys::number(field.name, field.unit, range, field.meaning);
  return key.or_else(
      field.otherwise != nullptr
          ? field.otherwise
          : fmt::format("firmware: {:g}", control_centre::described({}).at(field.name)));
}

// Checks the range also in single precision, which the outlets use.
void read_setting(const Table& table, const Field& field, double nominal_hz,
                  std::map<std::string, double>& settings) {
  const auto value = field.type == FieldType::kFloat
                         ? table.find_number(field.name, range_of(field, nominal_hz))
                         : std::optional<double>(table.find_whole(field.name));
  if (!value) {
    return;
  }
  const auto single = static_cast<float>(*value);
  if (!gs::outlet::within(field.range, single, static_cast<float>(nominal_hz))) {
    table.refuse(field.name, fmt::format("{} is {}; outlets use single precision, in which it is "
                                         "{} and out of range",
                                         field.name, *value, single));
  }
  settings[field.name] = *value;
}

}  // namespace

std::vector<Key> setting_keys() {
  std::vector<Key> keys;
  for (const Field& field : kSettingsFields) {
    if (field.meaning != nullptr) {
      keys.push_back(key_of(field));
    }
  }
  return keys;
}

void read_settings(const Table& table, double nominal_hz, std::map<std::string, double>& settings) {
  for (const Field& field : kSettingsFields) {
    if (field.meaning != nullptr) {
      read_setting(table, field, nominal_hz, settings);
    }
  }
}

}  // namespace gsbench::profile
