// Resampling by a windowed sinc.
#pragma once

#include <cstddef>
#include <vector>

namespace gsbench::scpi {

// Values of `in` at offset + n · step, n = 0 … count − 1, in samples of `in`, which is 0 outside.
// A step above 1 removes what the new rate cannot carry: above 90 % of its half. A step of at most
// 1 keeps up to 85 % of the half of the old rate within 1e-5 (Kaiser window, β = 11, 64 samples
// wide). At 8 kHz this includes the 40th harmonic of 60 Hz.
//
// A band-limited curve rings by 9 % of a step beside it. So within the reach of the window from a
// step of more than 5 % (of 1), and if `step` is at most 1, the values are joined by straight
// lines. The step itself comes half a sample before the later value: the samples do not say where
// between them it is, and so it is at most half a sample off.
//
// The same without that is band_limited(), for noise.
std::vector<float> band_limited(const std::vector<float>& in, double offset, double step,
                                std::size_t count);
std::vector<float> resampled(const std::vector<float>& in, double offset, double step,
                             std::size_t count);

}  // namespace gsbench::scpi
