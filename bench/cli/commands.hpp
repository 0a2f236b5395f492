// The commands of gsbench, and functions that they share. Each command adds itself to the command
// line.
#pragma once

#include "help.hpp"
#include <control_centre/blocks.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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
  // Bad usage, bad file (profile, grid, station, recording, settings), or an output that cannot be
  // written.
  kBadInput = 2,
  kInconclusive = 3,
  kErrored = 4,
  kInterrupted = 130,
};

// Threads for simulated outlets, the default of --threads: one per logical processor.
std::size_t default_threads();

ExitCode exit_code_of(record::Verdict verdict);

// Version of what --json prints, but for runs and their records (record::kFormatVersion). A change
// of what a key means, or a key less, makes a new version; new keys do not.
constexpr int kJsonFormatVersion = 1;

// Prints `value` on standard output, indented.
void print_json_document(const nlohmann::ordered_json& value);

// The same, with the key "format_version" before the others: in each object of a list, too.
void print_json(nlohmann::ordered_json value, int format_version = kJsonFormatVersion);

// Prints `line` on standard output, wrapped to at most render::kLineColumns columns. All lines but
// the first start with `indent` spaces.
void print_wrapped(const std::string& line, std::size_t indent = 0);

// The same if standard output is a terminal; otherwise the line is not wrapped, for scripts.
void print_line(const std::string& line, std::size_t indent = 0);

// Returns "gsbench: ", the text and a line end. The text is wrapped if standard error is a
// terminal; otherwise it is one line, for tools that read "FILE:LINE:COLUMN: …".
std::string error_line(const std::string& text);
void print_error(const std::string& text);

// Throws CLI::ValidationError if an option or argument was given as an empty text. In a script,
// that is a variable without a value, which must not pass for an option that was not given.
void refuse_empty_values(const CLI::App& command);

struct CommandLine {
  // Adds a command. `run` is called with the parsed arguments and returns the exit code.
  template <class Arguments>
  std::pair<CLI::App&, Arguments&> command(const std::string& name, const std::string& description,
                                           int (*run)(const Arguments&)) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(name, description)->group("Commands");
    command->formatter(help_formatter());
    command->set_help_flag("-h,--help", "Print this help");
    command->callback([this, command, arguments, run] {
      refuse_empty_values(*command);
      exit_code = run(*arguments);
    });
    return {*command, *arguments};
  }

  CLI::App app;
  int exit_code = kPassed;
};

// The help shows the present value of `value` as the default.
// `type` names the value: "N", "MW".
template <class Value>
CLI::Option* add_with_default(CLI::App& command, const std::string& name, Value& value,
                              const std::string& type, const std::string& description) {
  return command.add_option(name, value, description)->type_name(type)->capture_default_str();
}

// For check(): `low` to `high`, and not NaN.
CLI::Validator number_between(double low, double high);

// PROFILE and GRID: names of shipped files or of the user's own, or paths.
CLI::Option* add_profile(CLI::App& command, std::string& profile);
CLI::Option* add_grid(CLI::App& command, std::string& grid);

// --out: the folder that contains the runs.
CLI::Option* add_runs_folder(CLI::App& command, std::string& folder);

// --seed or the like: 0 … profile::kLargestSeed.
CLI::Option* add_seed(CLI::App& command, const std::string& name, std::uint64_t& seed,
                      const std::string& description);
CLI::Option* add_seed(CLI::App& command, std::optional<std::uint64_t>& seed,
                      const std::string& description);

void add_threads(CLI::App& command, std::size_t& threads);
void add_json_flag(CLI::App& command, bool& json);

// Options with named values: --noise-distribution, --accumulated, --loss-instant.
void add_noise_distribution(CLI::App& command, campaign::NoiseDistribution& distribution);
void add_accumulation(CLI::App& command, control_centre::Accumulation& accumulation);
void add_rules(CLI::App& command, control_centre::Rules& rules);
void add_loss_instant(CLI::App& command, campaign::LossInstant& instant);

void add_check(CommandLine& line);
void add_compare(CommandLine& line);
void add_devices(CommandLine& line);
void add_fleet(CommandLine& line);
void add_immunity(CommandLine& line);
void add_list(CommandLine& line);
void add_measures(CommandLine& line);
void add_monitor(CommandLine& line);
void add_params(CommandLine& line);
void add_rejudge(CommandLine& line);
void add_report(CommandLine& line);
void add_reproduce(CommandLine& line);
void add_run(CommandLine& line);
void add_runs(CommandLine& line);
void add_safe(CommandLine& line);
void add_schema(CommandLine& line);
void add_study(CommandLine& line);
void add_waveform(CommandLine& line);

}  // namespace gsbench::cli
