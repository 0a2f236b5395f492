// The sub-commands of gsbench. Each adds itself to the parser; what it does it does when the parser
// has understood everything, and leaves its exit code in `exit_code`.
#pragma once

#include <cstddef>
#include <cstdint>

#include <CLI/CLI.hpp>

#include <profile/load.hpp>
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

// As in a profile.
inline const CLI::Range kSeedRange(std::uint64_t{0}, profile::kLargestSeed);

// Threads that simulated outlets are played on, where nothing else is asked for.
std::size_t default_threads();

// What a verdict comes to.
ExitCode exit_code_of(record::Verdict verdict);

void add_check(CLI::App& app, int& exit_code);
void add_devices(CLI::App& app, int& exit_code);
void add_fleet(CLI::App& app, int& exit_code);
void add_list(CLI::App& app, int& exit_code);
void add_measures(CLI::App& app, int& exit_code);
void add_monitor(CLI::App& app, int& exit_code);
void add_params(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_reproduce(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_runs(CLI::App& app, int& exit_code);
void add_schema(CLI::App& app, int& exit_code);
void add_study(CLI::App& app, int& exit_code);
void add_waveform(CLI::App& app, int& exit_code);

}  // namespace gsbench::cli
