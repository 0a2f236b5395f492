// Abnormal frequency event, §5.1.
//
// The paper's rule, five successive drops, is met by chance once in 720 windows of independent
// noise and more often on a tracker's smooth output: hundreds of false events an hour. So the drops
// must also come to event_drop_hz in sum: 20 mHz is 5.7 standard deviations of the difference of
// two measurements 80 ms apart at 1 % noise, and half of what a loss of 500 MW gives in that time.
#pragma once

#include <outlet/history.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

// The course before the event is read where the event cannot have begun yet: detection takes up to
// ten reports.
constexpr int kBaselineAge = 11;
constexpr int kBaselineLength = 16;

struct Baseline {
  float frequency_hz = 0.0f;  // f_0
  float rocof_hz_s = 0.0f;
};

// Does the newest measurement complete an event? Needs kBaselineAge + kBaselineLength measurements.
bool event_detected(const Settings& settings, const History& history);

Baseline baseline(const History& history);

}  // namespace gs::outlet
