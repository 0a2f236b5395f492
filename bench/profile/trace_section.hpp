// A recording as the stimulus.
#pragma once

#include <string>

#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

keys::Key trace_keys();

// [signal.trace]: sets the stimulus's kind, trace and duration.
void read_trace_section(const keys::Table& signal, double nominal_hz, Stimulus& stimulus);

// The whole recording in place of whatever happens in the stimulus so far; what the signal is made
// of (noise, harmonics, DC offset) stays.
void replace_by_recording(const std::string& path, const recording::TraceColumns& columns,
                          double nominal_hz, Stimulus& stimulus);

}  // namespace gsbench::profile
