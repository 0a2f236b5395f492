#include "commands.hpp"
#include "live_output.hpp"
#include "progress.hpp"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include <equivalence/equivalence.hpp>
#include <profile/load.hpp>
#include <render/figures.hpp>
#include <render/layout.hpp>
#include <station/dry_run.hpp>
#include <station/run.hpp>
#include <station/station_file.hpp>
#include <station/station_lock.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;

struct CompareArguments {
  std::string profile;
  std::vector<std::string> stations = {"simulated", "emulated"};
  bool json = false;
};

struct Comparison {
  std::vector<record::RunRecord> runs;
  std::vector<equivalence::Row> rows;
};

// Throws what would refuse a run at one of the stations, before any has played.
void check_all(const profile::Plan& plan, const std::vector<station::StationFile>& files) {
  for (const station::StationFile& file : files) {
    const profile::Plan fitted = station::fit_to_station(file, plan);
    const auto station = file.make_station(fitted, {});
    static_cast<void>(station::dry_run(fitted, *station));
    const station::StationLock unused(station->ports(), "profile " + plan.name);
  }
}

Comparison play(const profile::Plan& plan, const std::vector<station::StationFile>& files,
                const std::atomic<bool>& stop, OutputState& output) {
  Comparison comparison;
  for (const station::StationFile& file : files) {
    const profile::Plan fitted = station::fit_to_station(file, plan);
    const auto station = file.make_station(fitted, {});
    const LiveOutput live(file, file.path);
    Progress progress(file.name);
    comparison.runs.push_back(
        station::run(fitted, *station,
                     {nullptr, &stop, [&](double part) { progress.show(part); },
                      [&](const std::string& what) { progress.show(what); },
                      [&](const std::string& what) {
                        progress.clear();
                        output.note_unknown(what);
                      }}));
    if (stop) {
      break;
    }
  }
  comparison.rows = equivalence::compare(plan, comparison.runs);
  return comparison;
}

void print_table(const Comparison& comparison) {
  std::vector<std::vector<std::string>> cells = {
      {"station", "outlet", "f RMS", "max", "V RMS", "max", "f1 RMS", "max", "plan f", "V", "t"},
      {"", "", "mHz", "mHz", "%", "%", "mHz", "mHz", "mHz", "%", "ms"}};
  for (const equivalence::Row& row : comparison.rows) {
    const record::BenchUncertainty& planned = comparison.runs[row.run].bench_uncertainty;
    cells.push_back(
        {comparison.runs[row.run].station, row.outlet, render::fixed(row.frequency_mhz.rms, 2),
         render::fixed(row.frequency_mhz.largest, 2), render::fixed(row.voltage_pct.rms, 3),
         render::fixed(row.voltage_pct.largest, 3), render::fixed(row.from_first_mhz.rms, 2),
         render::fixed(row.from_first_mhz.largest, 2), render::fixed(planned.frequency_mhz, 3),
         render::fixed(planned.voltage_pct, 3), render::fixed(planned.time_ms, 3)});
  }
  for (const std::string& line : render::aligned(cells, "llrrrrrrrrr")) {
    print_wrapped(line);
  }
  std::puts("");
  for (const char* line :
       {"f, V: reported frequency and voltage, less those of the profile. The drift of the "
        "outlet's clock against the source's is taken off the frequency.",
        "f1: reported frequency, less that of the first outlet in the table.",
        "plan: largest deviations that the source stated before the run, without noise."}) {
    print_wrapped(line, 4);
  }
  std::puts("");
  for (const record::RunRecord& run : comparison.runs) {
    print_wrapped(run.station + ": " + record::to_string(run.verdict) +
                      (run.verdict_reason.empty() ? "" : ", " + run.verdict_reason),
                  4);
  }
}

ordered_json json_of(const equivalence::Difference& difference) {
  return {{"rms", difference.rms}, {"largest", difference.largest}};
}

ordered_json json_of(const profile::Plan& plan, const Comparison& comparison) {
  ordered_json out = {{"profile", plan.name}, {"profile_sha256", plan.sha256}};
  out["stations"] = ordered_json::array();
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const record::RunRecord& run = comparison.runs[i];
    const record::BenchUncertainty& planned = run.bench_uncertainty;
    ordered_json outlets = ordered_json::array();
    for (const equivalence::Row& row : comparison.rows) {
      if (row.run == i) {
        outlets.push_back({{"id", row.outlet},
                           {"frequency_mhz", json_of(row.frequency_mhz)},
                           {"voltage_pct", json_of(row.voltage_pct)},
                           {"from_first_mhz", json_of(row.from_first_mhz)}});
      }
    }
    out["stations"].push_back({{"station", run.station},
                               {"verdict", record::to_string(run.verdict)},
                               {"planned",
                                {{"frequency_mhz", planned.frequency_mhz},
                                 {"voltage_pct", planned.voltage_pct},
                                 {"time_ms", planned.time_ms}}},
                               {"outlets", outlets}});
  }
  return out;
}

int compare(const CompareArguments& arguments) {
  const profile::Plan plan = profile::load_profile(arguments.profile);
  std::vector<station::StationFile> files;
  for (const std::string& name : arguments.stations) {
    files.push_back(station::load_station(name));
  }
  const std::atomic<bool>& stop = catch_interrupts();
  check_all(plan, files);
  OutputState output;
  return output.exit_code_of([&]() -> int {
    const Comparison comparison = play(plan, files, stop, output);
    if (arguments.json) {
      print_json(json_of(plan, comparison));
    } else {
      print_table(comparison);
    }
    record::Verdict worst = record::Verdict::kPass;
    for (const record::RunRecord& run : comparison.runs) {
      worst = std::max(worst, run.verdict);
    }
    return stop ? kInterrupted : exit_code_of(worst);
  });
}

}  // namespace

void add_compare(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "compare", "Play a profile at several stations and compare what outlets measured", compare);
  add_profile(command, arguments.profile);
  command
      .add_option("--station", arguments.stations,
                  "Name of a station, or a .toml file; may be given several times; the others are "
                  "compared with the first (default: simulated and emulated)")
      ->type_name("STATION")
      ->allow_extra_args(false);
  add_json_flag(command, arguments.json);
  command.footer(
      "Use a profile without noise: noise hides small differences. No run is stored.\n"
      "\n"
      "Examples:\n"
      "  gsbench compare regression/equivalence\n"
      "  gsbench compare regression/equivalence --station simulated --station my-station.toml");
}

}  // namespace gsbench::cli
