// Computes the samples of one stretch of the signal. The loops suit SIMD and do not call libm. Each
// sample is computed independently, so that the result does not depend on the division into
// stretches or on the vector width.
#pragma once

#include <array>
#include <vector>

namespace gsbench::waveform {

// x is the index of the sample in the block, and u = (x − start)·per_length. At sample x, the phase
// in cycles is base_cycles + x·cycles_per_sample + Σ cycles[k]·u^(k+1), and the amplitude is
// amplitude + u·amplitude_slope.
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

// Entry k of a series describes harmonic k: its amplitude, per unit of the fundamental, times
// cosine and sine of its phase where the fundamental's phase is zero. Entry 1 is the fundamental;
// entry 0 is not used.
struct Phasor {
  double real = 0.0;
  double imaginary = 0.0;
};

// Write samples first … first+count−1 of the block to out.
// sin(2π·cycles), error below 2·10⁻¹¹, the same on every machine.
double sine_of(double cycles);

void render_sine(const Stretch& stretch, int first, int count, float* out);
void render_harmonics(const Stretch& stretch, const std::vector<Phasor>& series, int first,
                      int count, float* out);

}  // namespace gsbench::waveform
