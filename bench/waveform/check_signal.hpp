#pragma once

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

// Throws std::invalid_argument if `spec`, the nominal frequency or the sample rate is outside the
// limits of synthesizer.hpp. The message has the value and the permitted range.
void check_signal(const SignalSpec& spec, double nominal_hz, std::int64_t sample_rate_hz);

}  // namespace gsbench::waveform
