// Load-shedding conditions, §4.3, §5.2 and Table 1.
#pragma once

#include <outlet/history.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

constexpr float kUnreached_hz_s = 1.0e9f;  // faster than any frequency falls

// The condition at a frequency is met if ROCOF is below this limit, Hz/s: that of the row that the
// frequency falls into. Below the lowest row f has already passed f_s, and any further fall meets
// the condition. At or above nominal no fall meets it.
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

// True if the line through the newest measurements meets the condition at its middle. Frequency and
// ROCOF must be of the same instant: a window's slope combined with its last frequency would count
// a loss below the threshold as one above it.
template <class Real>
auto condition_met(const Settings& settings, float nominal_hz, const LineOf<Real>& line) {
  return line.slope_hz_s < rocof_limit_hz_s(settings, nominal_hz, line.mean_hz);
}

}  // namespace gs::outlet
