// Detection of abnormal frequency events, §5.1.
//
// The paper's rule is five successive drops. Independent noise meets it once in 720 windows, and a
// tracker's smooth output meets it more often: over a thousand false events an hour at 1 % noise.
// Two further conditions apply:
// - The sum of the drops must be at least event_drop_hz. This rejects slow drifts: the
//   default, 14 mHz in 80 ms, corresponds to 0.175 Hz/s.
// - The newest measurement must lie event_departure_hz or more below the baseline. This rejects
//   noise: the default, 18 mHz, is eight standard deviations of a measurement at 1 % noise. A loss
//   of 500 MW exceeds this limit before the fifth drop.
// Together the two conditions delay detection by 3 ms. Fewer than one false event in a million
// hours remains. This figure is extrapolated from the false events of 20 hours with both limits set
// lower.
#pragma once

#include <outlet/history.hpp>

namespace gs::outlet {

struct Settings;

// The baseline is the frequency before the event, fitted over kBaselineLength reports. It ends
// kBaselineAge reports before detection, because detection takes up to ten reports.
constexpr int kBaselineAge = 11;
constexpr int kBaselineLength = 16;

struct Baseline {
  float frequency_hz = 0.0f;  // f_0
  float rocof_hz_s = 0.0f;
};

inline bool covers_baseline(const History& history) {
  return history.filled >= kBaselineAge + kBaselineLength;
}

// True if the newest measurement completes an event. False until the history covers the baseline.
bool event_detected(const Settings& settings, const History& history);

// The history must cover it.
Baseline baseline(const History& history);

}  // namespace gs::outlet
