#include "dialect.hpp"

#include "shown.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace gsbench::recording {
namespace {

constexpr double kMostRows = 1e6;

char delimiter_of(const TraceFormat& format) {
  const std::string& text = format.delimiter;
  if (text.empty()) {
    return format.decimal == "," ? ';' : ',';
  }
  if (text == "tab" || text == "\\t") {
    return '\t';
  }
  if (text == "space") {
    return ' ';
  }
  const auto c = static_cast<unsigned char>(text.front());
  // What numbers consist of, or quotes and lines.
  constexpr std::string_view kOthers = ".+-\"\n\r";
  if (text.size() > 1 || std::isalnum(c) != 0 || c == '\0' || c >= 0x80 ||
      kOthers.find(text.front()) != std::string_view::npos) {
    throw FormatError("delimiter",
                      fmt::format("delimiter is `{}`; it must be one character that is no letter, "
                                  "digit, point, sign or quote, or `tab` or `space`",
                                  shown(text)));
  }
  return text.front();
}

std::size_t rows_of(const char* key, double rows) {
  if (!(rows >= 0.0 && rows <= kMostRows) || rows != std::floor(rows)) {
    throw FormatError(key, fmt::format("{} is {}; it must be a whole number from 0 to {:.0f}", key,
                                       rows, kMostRows));
  }
  return static_cast<std::size_t>(rows);
}

// The factor of `unit`, one of `units` with these `factors`.
template <std::size_t count>
double factor_of(const char* key, const std::string& unit, const char* const (&units)[count],
                 const double (&factors)[count]) {
  const auto* const found = std::find(std::begin(units), std::end(units), unit);
  if (found == std::end(units)) {
    throw FormatError(key, fmt::format("{} is `{}`; it must be one of {}", key, shown(unit),
                                       fmt::join(units, ", ")));
  }
  return factors[found - std::begin(units)];
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

Dialect::Dialect(const TraceFormat& format, double nominal_hz)
    : format_(format),
      delimiter_(delimiter_of(format)),
      skip_rows_(rows_of("skip_rows", format.skip_rows)),
      header_rows_(rows_of("header_rows", format.header_rows)) {
  for (const std::string& gap : format.gaps) {
    gaps_.push_back(lower(trimmed(gap, " \t")));
  }
  if (format.decimal != "." && format.decimal != ",") {
    throw FormatError("decimal",
                      fmt::format("decimal is `{}`; it must be `.` or `,`", shown(format.decimal)));
  }
  time_unit_s_ = factor_of("time_unit", format.time_unit, kTimeUnits,
                           {1.0, 1e-3, 1e-6, 1e-9, 60.0, 3600.0, 86400.0});
  constexpr double kTurn = 6.28318530717958648;
  frequency_unit_hz_ = factor_of("frequency_unit", format.frequency_unit, kFrequencyUnits,
                                 {1.0, 1e-3, 1e3, 1.0 / kTurn, nominal_hz});
  if (!std::isfinite(format.frequency_offset_hz)) {
    throw FormatError("frequency_offset_hz", fmt::format("frequency_offset_hz is {}; it must be "
                                                         "finite",
                                                         format.frequency_offset_hz));
  }
  if (const std::string unknown = unknown_directive(format.time_format); !unknown.empty()) {
    throw FormatError("time_format", fmt::format("time_format has `{}`; it may have {}",
                                                 shown(unknown), kTimeDirectives));
  }
  if (format.nominal_voltage &&
      !(std::isfinite(*format.nominal_voltage) && *format.nominal_voltage > 0.0)) {
    throw FormatError("nominal_voltage",
                      fmt::format("nominal_voltage is {}; it must be finite and above 0",
                                  *format.nominal_voltage));
  }
  if (format.voltage.empty() && format.nominal_voltage) {
    throw FormatError("nominal_voltage",
                      "nominal_voltage is given without a voltage column; give both or none");
  }
}

std::optional<double> Dialect::number(const std::string& text) const {
  if (format_.decimal == ".") {
    return parse_number(text);
  }
  if (text.find('.') != std::string::npos) {
    return std::nullopt;
  }
  std::string with_point = text;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return parse_number(with_point);
}

std::optional<Instant> Dialect::instant(const std::string& text) const {
  if (!format_.time_format.empty()) {
    return parse_by_format(text, format_.time_format);
  }
  if (const std::optional<double> value = number(text)) {
    return instant_of_number(*value * time_unit_s_);
  }
  return parse_date_and_time(text);
}

double Dialect::frequency_hz(double value) const {
  return value * frequency_unit_hz_ + format_.frequency_offset_hz;
}

// Recorders mark missing measurements like this. A number among the words is compared as a number:
// -999 is also -999.0.
bool Dialect::is_gap(const std::string& text) const {
  const std::string word = lower(text);
  constexpr std::string_view kUsual[] = {"", "nan", "-nan", "na", "n/a", "null"};
  if (std::find(std::begin(kUsual), std::end(kUsual), word) != std::end(kUsual)) {
    return true;
  }
  const std::optional<double> value = number(text);
  return std::any_of(gaps_.begin(), gaps_.end(), [&](const std::string& gap) {
    return gap == word || (value && (number(gap) == value || parse_number(gap) == value));
  });
}

}  // namespace gsbench::recording
