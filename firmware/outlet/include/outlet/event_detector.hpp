// Abnormal frequency event, §5.1.
//
// The paper's rule, five successive drops, is met by chance once in 720 windows of independent
// noise and more often on a tracker's smooth output: over a thousand false events an hour at 1 %
// noise. So the drops must also come to event_drop_hz in sum, and the last of them lie
// event_departure_hz below the course before. Of the two the first keeps slow drifts out (14 mHz in
// 80 ms is 0.175 Hz/s), the second noise: 18 mHz is eight standard deviations of a measurement at 1
// % noise, and a loss of 500 MW passes it before the fifth drop. Together they leave less than one
// false event in a million hours by the tail seen in 20 hours at lower limits, and cost 3 ms of
// delay.
#pragma once

#include <outlet/history.hpp>

namespace gs::outlet {

struct Settings;

// The course before the event is read where the event cannot have begun yet: detection takes up to
// ten reports.
constexpr int kBaselineAge = 11;
constexpr int kBaselineLength = 16;

struct Baseline {
  float frequency_hz = 0.0f;  // f_0
  float rocof_hz_s = 0.0f;
};

// Does the newest measurement complete an event? Not before there is a whole baseline.
bool event_detected(const Settings& settings, const History& history);

Baseline baseline(const History& history);

}  // namespace gs::outlet
