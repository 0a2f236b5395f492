// The sub-commands of gsbench, and what they have in common. Each adds itself to the command line.
#pragma once

#include <control_centre/blocks.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <campaign/estimates.hpp>
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

// Threads that simulated outlets are played on, where nothing else is asked for.
std::size_t default_threads();

// What a verdict comes to.
ExitCode exit_code_of(record::Verdict verdict);

// SIGINT and SIGTERM ask a run to end in its safe state; a second one ends the process as usual.
const std::atomic<bool>& catch_interrupts();

// Indented, on standard output.
void print_json(const nlohmann::ordered_json& value);

inline const CLI::Range kSeeds{std::uint64_t{0}, profile::kLargestSeed};
inline const CLI::Range kThreads{1, 256};

struct CommandLine {
  // A new command and its arguments, with which `run` is called once they are parsed. It returns
  // the exit code.
  template <class Arguments>
  std::pair<CLI::App&, Arguments&> command(const std::string& name, const std::string& description,
                                           int (*run)(const Arguments&)) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(name, description);
    command->callback([this, arguments, run] { exit_code = run(*arguments); });
    return {*command, *arguments};
  }

  CLI::App app;
  int exit_code = kPassed;
};

// The help shows the value that the variable has now.
template <class Value>
CLI::Option* add_with_default(CLI::App& command, const std::string& name, Value& value,
                              const std::string& description) {
  return command.add_option(name, value, description)->capture_default_str();
}

// --out: the folder that keeps the runs.
CLI::Option* add_runs_folder(CLI::App& command, std::string& folder);

// Options that choose one of a few by name: --noise-distribution, --accumulated, --loss-instant.
void add_noise_distribution(CLI::App& command, campaign::NoiseDistribution& distribution);
void add_accumulation(CLI::App& command, control_centre::Accumulation& accumulation);
void add_loss_instant(CLI::App& command, campaign::LossInstant& instant);

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
