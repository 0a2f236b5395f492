// Nominal voltage before and after a stimulus, in phase with it.
#pragma once

#include <cstdint>

#include <source/stimulus.hpp>

namespace gsbench::head {

// Phase of the stimulus's fundamental at `tick`, as a cosine: the best fit of its course of
// frequency to the samples of some nominal periods from `first_tick` on. Harmonics of nominal
// frequency have no influence. `tick` may be the stimulus's end.
double phase_rad(const source::Stimulus& stimulus, std::int64_t first_tick, std::int64_t tick);

// Smallest number of samples that is a whole number of nominal periods.
std::int64_t repeats_after(std::int64_t sample_rate_hz, int nominal_hz);

class NominalVoltage {
 public:
  // The phase at sample `anchor`. From there on, the amplitude changes softly from `from_pu` to
  // nominal, for `ramp_samples`.
  NominalVoltage(const source::Stimulus& stimulus, std::int64_t anchor, double phase_rad,
                 double from_pu, std::int64_t ramp_samples);
  double at_pu(std::int64_t sample) const;

 private:
  std::int64_t rate_hz_;
  int nominal_hz_;
  std::int64_t anchor_;
  double phase_rad_;
  double from_pu_;
  std::int64_t ramp_samples_;
};

}  // namespace gsbench::head
