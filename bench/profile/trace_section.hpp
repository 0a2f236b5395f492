// A recording as the stimulus.
#pragma once

#include "table.hpp"

#include <string>

#include <profile/plan.hpp>

namespace gsbench::profile {

// A run's records are held in memory, 130 MB an outlet for this long; longer times are studied over
// many seeds.
constexpr double kLongestRun_s = 1.0e5;
// An outlet has 96 ms to answer to its settings.
constexpr double kShortestRun_s = 0.1;

// [signal.trace]: sets the stimulus's kind, trace and duration.
void read_trace_section(const Table& signal, double nominal_hz, Stimulus& stimulus);

// The whole recording in place of whatever happens in the stimulus so far; what the signal is made
// of (noise, harmonics, DC offset) stays.
void replace_by_recording(const std::string& path, const waveform::TraceColumns& columns,
                          double nominal_hz, Stimulus& stimulus);

}  // namespace gsbench::profile
