// The fundamental of a stimulus, for a source that continues it with a sine of its own, before its
// beginning or after its end, without a step of the voltage.
#pragma once

#include <complex>
#include <cstdint>

#include <source/stimulus.hpp>

namespace gsbench::source {

// Smallest number of samples that is a whole number of nominal periods.
std::int64_t repeats_after(std::int64_t sample_rate_hz, int nominal_hz);

// Amplitude, per unit of nominal peak, and phase at `tick`, 0 … total_ticks(): the voltage there is
// the real part. Least-squares fit of the stimulus's course of frequency to the repeats_after()
// samples before `tick`, or to the first ones of the stimulus if `tick` is closer to its beginning.
// Harmonics of nominal frequency have no influence.
std::complex<double> fundamental_pu(const Stimulus& stimulus, std::int64_t tick);

// Half a period of a cosine, from 0 at part 0 to 1 at part 1; constant outside.
double soft(double part);

}  // namespace gsbench::source
