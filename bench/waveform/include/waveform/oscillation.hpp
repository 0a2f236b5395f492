// An oscillation of the frequency at the outlets that is not one of the grid's mean frequency: an
// inter-area oscillation. Its deviation is a sine in [at_s, at_s + duration_s) and 0 outside.
#pragma once

#include <limits>

namespace gsbench::waveform {

struct Oscillation {
  double at_s = 0.0;                                            // >= 0
  double duration_s = std::numeric_limits<double>::infinity();  // > 0; infinity: to the end
  double frequency_hz = 0.5;                                    // of the oscillation; 0.05 … 5
  double amplitude_hz = 0.0;  // peak deviation of the mains frequency; 0 … 1
  double phase_deg = 0.0;     // at at_s; 0: rising from 0, without a step of the frequency

  // Right-hand limits at the start and end.
  double deviation_hz(double t_s) const;
  double rocof_hz_s(double t_s) const;
  // ∫ deviation_hz dt from at_s, cycles, exact; constant after the end.
  double excess_cycles(double t_s) const;
};

constexpr double kSlowestOscillation_hz = 0.05;
constexpr double kFastestOscillation_hz = 5.0;
constexpr double kLargestOscillation_hz = 1.0;

}  // namespace gsbench::waveform
