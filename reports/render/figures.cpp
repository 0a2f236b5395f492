#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <render/figures.hpp>

namespace gsbench::render {
namespace {

constexpr int kMostDecimals = 9;

int magnitude_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::string not_finite(double value) {
  if (std::isnan(value)) {
    return "–";
  }
  return value > 0.0 ? "∞" : "-∞";
}

}  // namespace

std::string figure(double value, int significant) {
  if (!std::isfinite(value)) {
    return not_finite(value);
  }
  if (value == 0.0) {
    return "0";
  }
  const int decimals = significant - 1 - magnitude_of(value);
  if (decimals > kMostDecimals) {
    return fmt::format("{:.{}g}", value, significant);
  }
  std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) {
    return not_finite(value);
  }
  std::string text = fmt::format("{:.{}f}", value, std::clamp(decimals, 0, kMostDecimals));
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

int decimals_for(const std::vector<double>& values, double uncertainty) {
  if (std::isfinite(uncertainty) && uncertainty > 0.0) {
    return std::clamp(static_cast<int>(std::lround(-std::log10(uncertainty))), 0, kMostDecimals);
  }
  bool all_whole = true;
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) {
      all_whole = all_whole && value == std::round(value);
      largest = std::max(largest, std::abs(value));
    }
  }
  if (all_whole) {
    return 0;
  }
  const int significant = largest < 1.0 ? 2 : largest < 10.0 ? 3 : 4;
  return std::clamp(significant - 1 - magnitude_of(largest), 0, kMostDecimals);
}

int decimals_of_two_digits(double value) {
  return value == 0.0 || !std::isfinite(value)
             ? 0
             : std::clamp(1 - magnitude_of(value), 0, kMostDecimals);
}

int decimals_of_written(double value) {
  const std::string text = figure(value, 6);
  const std::size_t point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

}  // namespace gsbench::render
