// An emulated frequency relay: a device under test that has no link and no firmware of this
// project, only terminals and a contact. It opens the contact when the frequency has been below its
// pick-up value for its delay, and keeps it open.
#pragma once

#include <cstdint>

namespace gsbench::emulation {

struct FrequencyRelayOptions {
  double pickup_hz = 49.0;
  double delay_s = 0.15;
};

// Once a period, measures the frequency from the rising zero crossings of the last kPeriods
// periods. So the frequency is about kPeriods/2 periods old. If two crossings are more than two
// nominal periods apart, the measurement restarts, and the delay with it.
class FrequencyRelay {
 public:
  static constexpr int kPeriods = 5;

  // `nominal_hz` > 0. Samples are counts of its ADC, counts_per_pu at the nominal peak.
  FrequencyRelay(const FrequencyRelayOptions& options, std::int64_t sample_rate_hz, int nominal_hz,
                 float counts_per_pu);

  // Takes the next sample. Returns whether the contact is commanded to be closed.
  bool take(std::int16_t counts);

 private:
  void cross(double at_s);

  FrequencyRelayOptions options_;
  double sample_s_;
  double longest_period_s_;
  double armed_below_;  // counts; a hysteresis, so that noise around zero makes no crossings
  std::int64_t sample_ = 0;
  double last_ = 0.0;  // sample before, counts
  bool armed_ = false;
  double crossed_s_[kPeriods + 1] = {};  // times of the newest crossings, as a ring
  std::int64_t crossings_ = 0;           // since the last gap
  double below_since_s_ = 0.0;
  bool below_ = false;
  bool closed_ = true;
};

}  // namespace gsbench::emulation
