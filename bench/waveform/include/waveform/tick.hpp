// Instants in seconds as ticks, the same rule for what is played, marked and judged.
#pragma once

#include <cstdint>

namespace gsbench::waveform {

// The first tick at or after t_s, an instant within a nanosecond of a sample being at that sample;
// the largest one for times past the end of counting.
std::int64_t tick_at(double t_s, std::int64_t sample_rate_hz);

}  // namespace gsbench::waveform
