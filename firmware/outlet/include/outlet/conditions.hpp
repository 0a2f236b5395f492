// Load-shedding conditions, §4.3, §5.2 and Table 1.
#pragma once

#include <outlet/history.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

constexpr float kUnreached_hz_s = 1.0e9f;  // no frequency falls so fast

// The ROCOF below which the condition at a frequency is met; its row's. Below the lowest row f has
// passed f_s already, and any further fall meets the condition; above the uppermost none does.
// `Real`: float, or a vector of floats, one trajectory a lane.
template <class Real>
Real rocof_limit_hz_s(const Settings& settings, float nominal_hz, Real frequency_hz) {
  Real limit{};
  for (int row = settings.condition_rows - 1; row >= 0; --row) {
    limit = select(frequency_hz >= settings.conditions[row].from_hz,
                   Real{} + settings.conditions[row].rocof_below_hz_s, limit);
  }
  return select(frequency_hz < nominal_hz, limit, Real{} - kUnreached_hz_s);
}

// Does a line through the newest measurements meet the row that its middle falls into? Frequency
// and ROCOF must be of the same instant: the slope over a window held against the window's last
// frequency counts a loss below the threshold as one above it.
template <class Real>
auto condition_met(const Settings& settings, float nominal_hz, const LineOf<Real>& line) {
  return line.slope_hz_s < rocof_limit_hz_s(settings, nominal_hz, line.mean_hz);
}

}  // namespace gs::outlet
