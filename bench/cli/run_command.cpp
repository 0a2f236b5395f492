#include "commands.hpp"
#include "dry_run.hpp"
#include "live_output.hpp"
#include "progress.hpp"
#include "record_view.hpp"
#include "run_folder.hpp"
#include "trace_arguments.hpp"
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>
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
  bool dry_run = false;
  bool csv = false;
  bool json = false;
};

void print(const render::View& view, bool as_json) {
  const bool colour = !as_json && isatty(STDOUT_FILENO) == 1;
  const std::string text = as_json  ? render::json(view)
                           : colour ? render::coloured_terminal(view)
                                    : render::terminal(view);
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

// Of a run that did not reach its end, what is printed has parts of the record. If that cannot be
// read, the run is still kept.
void print_kept(const record::RunRecord& run, const RunFolder& folder, bool as_json) {
  try {
    record::Reader reader(folder.file(kRecordFile));
    print(view_of(run, reader), as_json);
  } catch (const record::StoreError& error) {
    print_error(error.what());
    print_error(record::to_string(run.verdict) + (": " + run.verdict_reason));
  }
}

void keep_reports(const record::RunRecord& run, const RunFolder& folder,
                  const RunArguments& arguments) {
  try {
    record::Reader reader(folder.file(kRecordFile));
    write_reports(view_of(run, reader), folder.path(), arguments.csv);
  } catch (const render::WriteError& error) {
    // The exit code says that the run failed, not that its reports are missing.
    if (run.verdict != record::Verdict::kError) {
      throw;
    }
    print_error(error.what());
    return;
  }
  if (!arguments.json) {
    std::printf("\nReport: %s\n", folder.file(render::find_format("html")->file).c_str());
  }
}

int run(const RunArguments& arguments) {
  const profile::Plan asked = profile::load_profile(arguments.profile, arguments.overrides);
  print_recording(asked);
  const auto file = station::load_station(arguments.station);
  const profile::Plan plan = station::fit_to_station(file, asked);
  const std::atomic<bool>& interrupted = catch_interrupts();
  // The run and its reports are kept also if nobody reads what is printed.
  std::signal(SIGPIPE, SIG_IGN);
  const auto station = file.make_station(plan, arguments.simulated);

  if (arguments.dry_run) {
    return dry_run(plan, *station, arguments.json);
  }
  OutputState output;
  return output.exit_code_of([&] {
    RunFolder folder(arguments.output_folder);
    record::RunRecord run;
    {
      record::Writer writer(folder.file(kRecordFile));
      const LiveOutput live(file, arguments.station);
      Progress progress(plan.name);
      run = station::run(plan, *station,
                         {&writer, &interrupted, [&](double part) { progress.show(part); },
                          [&](const std::string& what) { progress.show(what); },
                          [&](const std::string& what) {
                            progress.clear();
                            output.note_unknown(what);
                          },
                          file.text});
    }
    // First: a report that cannot be written must not hide the verdict.
    if (!is_judged(run)) {
      print_kept(run, folder, arguments.json);
    } else {
      print(run, arguments.json);
    }
    folder.keep(run.run_id);
    keep_reports(run, folder, arguments);
    return run.interrupted ? kInterrupted : exit_code_of(run.verdict);
  });
}

}  // namespace

void add_run(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "run", "Play a profile into outlets, judge what they did, and keep a report", run);
  add_profile(command, arguments.profile);
  add_runs_folder(command, arguments.output_folder);
  add_seed(command, arguments.overrides.seed, "Seed of the noise, in place of the profile's");
  add_with_default(command, "--station", arguments.station, "STATION",
                   "Where the outlets are: name of a station, or a .toml file");
  command.add_flag("--real-time", arguments.simulated.real_time,
                   "Play simulated outlets in real time, not as fast as possible");
  add_threads(command, arguments.simulated.threads);
  add_trace(command, arguments.overrides);
  command.add_flag("--dry-run", arguments.dry_run,
                   "Print what would be played, how accurately, and into which outlets; energise "
                   "nothing");
  command.add_flag("--csv", arguments.csv,
                   "Also keep traces.csv: what each outlet measured and estimated. Otherwise "
                   "`gsbench report RUN --format csv` prints it");
  add_json_flag(command, arguments.json);
  command.footer(
      "With --trace, the limits of the profile also apply to the recording. Measures that need a\n"
      "loss are then INCONCLUSIVE: use a profile without limits on them.\n"
      "\n"
      "Examples:\n"
      "  gsbench run paper/loss-500mw\n"
      "  gsbench run paper/loss-500mw --station my-station.toml --dry-run\n"
      "  gsbench run my-profile.toml --seed 7 --out my-runs --json\n"
      "  gsbench run my-profile.toml --trace grid.csv --trace-time time --trace-frequency f");
}

}  // namespace gsbench::cli
