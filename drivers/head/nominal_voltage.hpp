// Nominal voltage before and after a stimulus, in phase with it.
#pragma once

#include <cstdint>

#include <source/stimulus.hpp>

namespace gsbench::head {

class NominalVoltage {
 public:
  // Sample `anchor` has the phase of the stimulus at `tick`. From there on, the amplitude changes
  // softly from `from_pu` to nominal, for `ramp_samples`.
  NominalVoltage(const source::Stimulus& stimulus, std::int64_t tick, std::int64_t anchor,
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
