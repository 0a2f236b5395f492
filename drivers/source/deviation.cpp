#include <algorithm>
#include <cmath>

#include <source/deviation.hpp>

namespace gsbench::source {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWindow_s = 0.2;
constexpr double kLowest_pu = 0.05;

// Slope of the least-squares line through values at 0, 1, 2, …
double slope_of(const std::vector<double>& values) {
  const double middle = 0.5 * static_cast<double>(values.size() - 1);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    products += x * values[i];
    squares += x * x;
  }
  return products / squares;
}

}  // namespace

DeviationMeter::DeviationMeter(std::int64_t sample_rate_hz, int nominal_hz)
    : period_ticks_(std::llround(static_cast<double>(sample_rate_hz) / nominal_hz)),
      period_s_(static_cast<double>(period_ticks_) / static_cast<double>(sample_rate_hz)),
      step_rad_(2.0 * kPi * nominal_hz / static_cast<double>(sample_rate_hz)) {}

void DeviationMeter::add(const float* ideal_pu, const float* played_pu, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto ideal = static_cast<double>(ideal_pu[i]);
    const auto played = static_cast<double>(played_pu[i]);
    largest_.voltage_pu = std::max(largest_.voltage_pu, std::fabs(played - ideal));
    const std::complex<double> carrier = std::polar(1.0, -step_rad_ * static_cast<double>(tick_));
    const double weight =
        0.5 - 0.5 * std::cos(kPi * static_cast<double>(tick_) / static_cast<double>(period_ticks_));
    ideal_.add(ideal, carrier, weight);
    played_.add(played, carrier, weight);
    if (++tick_ == period_ticks_) {
      end_period();
    }
  }
}

std::complex<double> DeviationMeter::Coefficient::end_period() {
  const std::complex<double> whole = rising_before + falling;
  rising_before = rising;
  rising = {};
  falling = {};
  return whole;
}

void DeviationMeter::end_period() {
  const std::complex<double> ideal = ideal_.end_period();
  const std::complex<double> played = played_.end_period();
  tick_ = 0;
  const auto lowest = 0.5 * kLowest_pu * static_cast<double>(period_ticks_);
  if (std::abs(ideal) < lowest || std::abs(played) < lowest) {
    difference_rad_.clear();
  } else {
    difference_rad_.push_back(std::arg(played * std::conj(ideal)));
    const auto window = static_cast<std::size_t>(std::llround(kWindow_s / period_s_));
    if (difference_rad_.size() > window) {
      difference_rad_.erase(difference_rad_.begin());
    }
    if (difference_rad_.size() == window) {
      const double deviation_hz = slope_of(difference_rad_) / (2.0 * kPi * period_s_);
      largest_.frequency_hz = std::max(largest_.frequency_hz, std::fabs(deviation_hz));
    }
  }
}

}  // namespace gsbench::source
