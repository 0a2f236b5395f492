// --trace and its options, and what is said about a recording that is played.
#pragma once

#include "commands.hpp"

#include <profile/load.hpp>

namespace gsbench::cli {

void add_trace(CLI::App& command, profile::Overrides& overrides);

// Prints on standard error how much of a recording the plan plays, and a warning if its frequency
// is not near the grid's nominal frequency. Prints nothing for a plan without a recording.
void print_recording(const profile::Plan& plan);

}  // namespace gsbench::cli
