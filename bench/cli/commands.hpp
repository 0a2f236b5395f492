// The sub-commands of gsbench, and what they have in common. Each adds itself to the command line.
#pragma once

#include "arguments.hpp"

#include <cstddef>

#include <record/run_record.hpp>

namespace gsbench::cli {

enum ExitCode : int {
  kPassed = 0,
  kFailed = 1,
  kBadInput = 2,  // usage, profile, settings, a place that cannot be written
  kInconclusive = 3,
  kErrored = 4,
  kInterrupted = 130,
};

// Threads that simulated outlets are played on, where nothing else is asked for.
std::size_t default_threads();

// What a verdict comes to.
ExitCode exit_code_of(record::Verdict verdict);

void add_check(CommandLine& line);
void add_devices(CommandLine& line);
void add_fleet(CommandLine& line);
void add_list(CommandLine& line);
void add_measures(CommandLine& line);
void add_monitor(CommandLine& line);
void add_params(CommandLine& line);
void add_report(CommandLine& line);
void add_reproduce(CommandLine& line);
void add_run(CommandLine& line);
void add_runs(CommandLine& line);
void add_schema(CommandLine& line);
void add_study(CommandLine& line);
void add_waveform(CommandLine& line);

}  // namespace gsbench::cli
