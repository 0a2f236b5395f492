#include "commands.hpp"
#include "progress.hpp"
#include "run_folder.hpp"
#include <unistd.h>

#include <cstdio>
#include <optional>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/render.hpp>
#include <station/run.hpp>
#include <station/station_file.hpp>

namespace gsbench::cli {
namespace {

struct RunArguments {
  std::string profile;
  profile::Overrides overrides;
  std::string output_folder = default_runs_folder();
  std::string station = "simulated";
  station::SimulatedOptions simulated;
  bool json = false;
};

int run(const RunArguments& arguments) {
  const profile::Plan asked = profile::load_profile(arguments.profile, arguments.overrides);
  const auto file = station::load_station(arguments.station);
  const profile::Plan plan = station::fit_to_station(file, asked);
  const std::atomic<bool>& interrupted = catch_interrupts();
  const auto station = file.make_station(plan, arguments.simulated);

  RunFolder folder(arguments.output_folder);
  record::RunRecord run;
  {
    record::Writer writer(folder.file(kRecordFile));
    Progress progress(plan.name);
    run = station::run(plan, *station,
                       {&writer, &interrupted, [&](double part) { progress.show(part); }});
  }
  folder.keep(run.run_id);
  write_reports(run, folder.path());

  if (arguments.json) {
    std::fputs(render::json(run).c_str(), stdout);
  } else {
    const bool colour = isatty(STDOUT_FILENO) == 1;
    std::fputs((colour ? render::coloured_terminal(run) : render::terminal(run)).c_str(), stdout);
    std::printf("\nReport: %s\n", folder.file(render::find_format("html")->file).c_str());
  }
  return run.interrupted ? kInterrupted : exit_code_of(run.verdict);
}

}  // namespace

void add_run(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "run", "Play a profile into outlets, judge what they did, keep and report it", run);
  arguments.simulated.threads = default_threads();
  command.add_option("profile", arguments.profile, "A shipped profile, or a .toml file")
      ->required();
  add_runs_folder(command, arguments.output_folder);
  command
      .add_option("--seed", arguments.overrides.seed,
                  "Seed of the noise, in place of the profile's")
      ->check(kSeeds);
  add_with_default(command, "--station", arguments.station,
                   "Where the outlets are: a shipped station, or a .toml file");
  command.add_flag("--real-time", arguments.simulated.real_time,
                   "Pace by the wall clock, not as fast as possible");
  add_with_default(command, "--threads", arguments.simulated.threads,
                   "For simulated outlets; the result is the same for any")
      ->check(kThreads);
  recording::TraceColumns& columns = arguments.overrides.trace_columns;
  CLI::Option* trace =
      command.add_option("--trace", arguments.overrides.trace_path,
                         "Play this CSV recording in place of the profile's frequency");
  command.add_option("--trace-time", columns.time, "Its column of times")->needs(trace);
  command.add_option("--trace-frequency", columns.frequency, "Its column of frequencies, Hz")
      ->needs(trace);
  command
      .add_option("--trace-voltage", columns.voltage, "Its column of RMS voltages; none: nominal")
      ->needs(trace);
  command
      .add_option("--trace-nominal-voltage", columns.nominal_voltage,
                  "Nominal voltage in that column's unit; none: the column's median")
      ->needs(trace);
  command.add_flag("--json", arguments.json, "Print the result as JSON");
  command.footer(
      "Examples:\n"
      "  gsbench run paper/loss-500mw\n"
      "  gsbench run my-profile.toml --seed 7 --out my-runs --json\n"
      "  gsbench run my-profile.toml --trace grid.csv --trace-time time --trace-frequency f\n"
      "With --trace the profile's limits still hold: take one without a loss to detect.");
}

}  // namespace gsbench::cli
