#include "commands.hpp"

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>

namespace {

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

int complain(const char* what, int exit_code) {
  std::fprintf(stderr, "gsbench: %s\n", what);
  return exit_code;
}

std::string usage_mistake(const CLI::App* app, const CLI::Error& error) {
  const std::vector<std::string> unknown = app->remaining();
  const bool no_command = app->get_subcommands().empty() && !unknown.empty();
  return "gsbench: " + (no_command ? unknown.front() + " is no command" : error.what()) +
         "; `gsbench --help` and `gsbench COMMAND --help` say more\n";
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = gsbench::cli;
  CLI::App app(kAbout, "gsbench");
  app.footer(kExitCodes);
  app.set_version_flag("--version", GSBENCH_VERSION);
  app.require_subcommand(1);
  app.failure_message(usage_mistake);
  int exit_code = cli::kPassed;
  cli::add_run(app, exit_code);
  cli::add_list(app, exit_code);
  cli::add_check(app, exit_code);
  cli::add_params(app, exit_code);
  cli::add_waveform(app, exit_code);
  cli::add_report(app, exit_code);
  cli::add_runs(app, exit_code);
  cli::add_study(app, exit_code);
  cli::add_reproduce(app, exit_code);
  cli::add_fleet(app, exit_code);
  cli::add_measures(app, exit_code);
  cli::add_schema(app, exit_code);
  cli::add_devices(app, exit_code);
  cli::add_monitor(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? cli::kPassed : cli::kBadInput;
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
  return exit_code;
}
