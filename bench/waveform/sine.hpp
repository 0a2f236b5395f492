// Samples of one stretch of the signal, in loops for SIMD and without libm. Each sample is computed
// independently, so that the result does not depend on the division into stretches or on the vector
// width.
#pragma once

#include <array>
#include <vector>

namespace gsbench::waveform {

// With x the index of the sample in the block and u = (x − start)·per_length:
// phase = base_cycles + x·cycles_per_sample + Σ cycles[k]·u^(k+1), amplitude = amplitude + u·slope.
struct Stretch {
  double base_cycles;
  double cycles_per_sample;
  double start;
  double per_length;
  std::array<double, 5> cycles;
  double amplitude;
  double amplitude_slope;
  double offset;
};

// Entry k of a series: (cosine, sine) of harmonic k's phase at the fundamental's zero phase, times
// its amplitude per unit of the fundamental. Entry 0 is not used, entry 1 is the fundamental.
struct Phasor {
  double real = 0.0;
  double imaginary = 0.0;
};

// Write samples first … first+count−1 of the block to out.
void render_sine(const Stretch& stretch, int first, int count, float* out);
void render_harmonics(const Stretch& stretch, const std::vector<Phasor>& series, int first,
                      int count, float* out);

}  // namespace gsbench::waveform
