// The harmonics of public supply, for `harmonic_set = "en50160"`.
#pragma once

#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::profile {

// Orders 2 … 25, each at its limit of EN 50160; total distortion 11.3 %, above the standard's limit
// of 8 %. Phases are multiples of the golden angle.
std::vector<waveform::Harmonic> en50160_harmonics();

}  // namespace gsbench::profile
