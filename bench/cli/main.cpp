#include "commands.hpp"

#include <cstdio>
#include <exception>
#include <new>

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

}  // namespace

int main(int argc, char** argv) {
  namespace cli = gsbench::cli;
  cli::CommandLine line(kAbout, kExitCodes, GSBENCH_VERSION);
  cli::add_run(line);
  cli::add_list(line);
  cli::add_check(line);
  cli::add_params(line);
  cli::add_waveform(line);
  cli::add_report(line);
  cli::add_runs(line);
  cli::add_study(line);
  cli::add_reproduce(line);
  cli::add_fleet(line);
  cli::add_measures(line);
  cli::add_schema(line);
  cli::add_devices(line);
  cli::add_monitor(line);
  int exit_code = cli::kPassed;
  try {
    exit_code = line.run(argc, argv);
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
