// Load-shedding conditions, §4.3, §5.2 and Table 1.
#pragma once

#include <outlet/history.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

constexpr float kUnreached_hz_s = 1.0e9f;  // no grid frequency falls this fast

// Limit of the ROCOF at a frequency, Hz/s. The condition is met if the ROCOF is below the limit:
// - Within the table, the limit is that of the row whose range contains the frequency.
// - Below the lowest row, f has already passed f_s. The limit is 0: any further fall meets the
//   condition.
// - At or above nominal, no fall meets the condition.
// `Real`: float, or a vector of floats with one trajectory per lane.
template <class Real>
Real rocof_limit_hz_s(const Settings& settings, float nominal_hz, Real frequency_hz) {
  Real limit{};
  for (int row = settings.condition_rows - 1; row >= 0; --row) {
    limit = select(frequency_hz >= settings.conditions[row].from_hz,
                   Real{} + settings.conditions[row].rocof_below_hz_s, limit);
  }
  return select(frequency_hz < nominal_hz, limit, Real{} - kUnreached_hz_s);
}

// `line` is fitted through the newest measurements. True if its slope meets the condition at its
// mean frequency. Frequency and ROCOF must belong to the same instant, the middle of the window.
// With the window's last frequency, a loss below the threshold would count as one above it.
template <class Real>
auto condition_met(const Settings& settings, float nominal_hz, const LineOf<Real>& line) {
  return line.slope_hz_s < rocof_limit_hz_s(settings, nominal_hz, line.mean_hz);
}

}  // namespace gs::outlet
