// Sets of harmonics that a profile can name instead of listing them.
#pragma once

#include <string>
#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::profile {

std::vector<std::string> harmonic_set_names();

// `name` is one of harmonic_set_names().
std::vector<waveform::Harmonic> harmonic_set(const std::string& name);

}  // namespace gsbench::profile
