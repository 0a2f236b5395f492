#include "format.hpp"

#include <QString>
#include <cmath>
#include <limits>

namespace gsbench::render {
namespace {

// Two significant digits, never rounded down; the error of a binary fraction does not round up.
std::string rounded_up(double uncertainty) {
  const int decimals = decimals_of_two_digits(uncertainty);
  const double per_unit = std::pow(10.0, decimals);
  return fixed(std::ceil(uncertainty * per_unit - 1e-6) / per_unit, decimals);
}

bool is_inside(double value, const record::MeasurementResult& result) {
  return !(value < result.low) && !(value > result.high);
}

// As many digits as are needed to stay on its side of the limits.
std::string without_uncertainty(const record::MeasurementResult& result) {
  constexpr int kMostShown = 9;
  int decimals = decimals_for({result.value});
  std::string text = fixed(result.value, decimals);
  while (std::isfinite(result.value) && decimals < kMostShown &&
         is_inside(std::stod(text), result) != is_inside(result.value, result)) {
    text = fixed(result.value, ++decimals);
  }
  return text;
}

}  // namespace

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + ' ' + unit;
}

std::string limits(const record::MeasurementResult& result) {
  if (!result.judged) {
    return "";
  }
  if (!result.expected_text.empty()) {
    return result.expected_text;
  }
  const bool has_low = !std::isnan(result.low);
  const bool has_high = !std::isnan(result.high);
  if (!has_low && !has_high) {
    return "";
  }
  const std::string low = figure(result.low, 6);
  const std::string high = figure(result.high, 6);
  if (!has_high) {
    return with_unit("≥ " + low, result.unit);
  }
  if (!has_low) {
    return with_unit("≤ " + high, result.unit);
  }
  if (result.low == result.high) {
    return with_unit("= " + low, result.unit);
  }
  return with_unit(low + " … " + high, result.unit);
}

std::string value_of(const record::MeasurementResult& result) {
  if (!result.text.empty()) {
    return result.text;
  }
  if (std::isnan(result.value)) {
    return "–";
  }
  if (!std::isfinite(result.uncertainty) || result.uncertainty <= 0.0) {
    return with_unit(without_uncertainty(result), result.unit);
  }
  return with_unit(fixed(result.value, decimals_of_two_digits(result.uncertainty)) + " ± " +
                       rounded_up(result.uncertainty),
                   result.unit);
}

double seconds(const record::RunRecord& run, std::int64_t tick) {
  if (run.sample_rate_hz <= 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(tick) / static_cast<double>(run.sample_rate_hz);
}

std::string valid_text(const std::string& text) {
  QString unicode = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
  for (QChar& character : unicode) {
    const ushort code = character.unicode();
    const bool control = (code < 0x20 && code != '\t' && code != '\n') ||
                         (code >= 0x7f && code < 0xa0) || code >= 0xfffe;
    if (control) {
      character = QChar::ReplacementCharacter;
    }
  }
  return unicode.toStdString();
}

}  // namespace gsbench::render
