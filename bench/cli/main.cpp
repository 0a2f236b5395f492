#include "commands.hpp"

#include <cstdio>
#include <exception>
#include <new>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>

namespace {

namespace cli = gsbench::cli;

constexpr const char* kAbout =
    "gsbench plays the frequency response of a power system into Grid Sense outlets, captures "
    "what\n"
    "they measured, estimated and switched, and judges it.\n"
    "\n"
    "  gsbench run paper/loss-500mw        play, judge, report\n"
    "  gsbench list                        the profiles there are\n"
    "  gsbench params ieee24               what the control centre works out for a grid\n";

constexpr const char* kExitCodes =
    "Exit codes: 0 PASS; 1 FAIL; 2 bad usage, profile, settings or output folder;\n"
    "3 INCONCLUSIVE; 4 ERROR; 130 interrupted.";

std::string usage_mistake(const CLI::App* app, const CLI::Error& error) {
  const std::vector<std::string> unknown = app->remaining();
  const bool no_command = app->get_subcommands().empty() && !unknown.empty();
  return "gsbench: " + (no_command ? unknown.front() + " is no command" : error.what()) +
         "; `gsbench --help` and `gsbench COMMAND --help` say more\n";
}

int complain(const char* what, int exit_code) {
  std::fprintf(stderr, "gsbench: %s\n", what);
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  cli::CommandLine line{CLI::App(kAbout, "gsbench")};
  line.app.footer(kExitCodes);
  line.app.set_version_flag("--version", GSBENCH_VERSION);
  line.app.require_subcommand(1);
  line.app.failure_message(usage_mistake);
  for (const auto add :
       {cli::add_run, cli::add_list, cli::add_check, cli::add_params, cli::add_waveform,
        cli::add_report, cli::add_runs, cli::add_study, cli::add_reproduce, cli::add_fleet,
        cli::add_measures, cli::add_schema, cli::add_devices, cli::add_monitor}) {
    add(line);
  }
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    line.exit_code = line.app.exit(error) == 0 ? cli::kPassed : cli::kBadInput;
  } catch (const gsbench::profile::ConfigurationError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const gsbench::record::StoreError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const gsbench::render::WriteError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const std::bad_alloc&) {
    return complain(
        "out of memory: fewer outlets, a shorter run or fewer --threads would need less",
        cli::kErrored);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::kErrored);
  }
  // What standard output could not take has been lost: say so.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return complain("standard output cannot be written", cli::kBadInput);
  }
  return line.exit_code;
}
