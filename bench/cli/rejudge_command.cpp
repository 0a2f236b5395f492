#include "commands.hpp"
#include "run_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <installation/installation.hpp>
#include <judge/judge.hpp>
#include <judge/plan_of.hpp>
#include <record/store.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

using record::MeasurementResult;

struct RejudgeArguments {
  std::string run;
  std::string output_folder = default_runs_folder();
  bool json = false;
};

// A measurement, or a verdict, that is not what the record has.
struct Difference {
  std::string outlet;  // empty: of the run
  std::string what;
  std::string recorded;
  std::string now;
};

struct Rejudged {
  record::RunRecord run;  // the outlets without measurements
  record::Verdict recorded = record::Verdict::kPass;
  std::vector<Difference> differences;
};

bool is_equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool is_equal(const MeasurementResult& a, const MeasurementResult& b) {
  return a.name == b.name && a.unit == b.unit && a.text == b.text &&
         a.expected_text == b.expected_text && a.judged == b.judged && a.verdict == b.verdict &&
         is_equal(a.value, b.value) && is_equal(a.low, b.low) && is_equal(a.high, b.high) &&
         is_equal(a.uncertainty, b.uncertainty);
}

std::string text_of(const MeasurementResult& result) {
  std::string text = result.text.empty() ? fmt::format("{}", result.value) : result.text;
  text += result.unit.empty() ? "" : " " + result.unit;
  return result.judged ? text + ", " + record::to_string(result.verdict) : text;
}

// Results are in the order of the profile's limits, then of the catalogue. A measure that was added
// to the catalogue since is a difference only with a limit, and does not move those after it.
void compare(const record::OutletRecord& recorded, const record::OutletRecord& now,
             std::vector<Difference>& differences) {
  const std::vector<MeasurementResult>& before = recorded.measurements;
  const std::vector<MeasurementResult>& after = now.measurements;
  for (std::size_t b = 0, a = 0; b < before.size() || a < after.size();) {
    const bool is_new =
        b == before.size() ||
        (a < after.size() && record::find_measurement(recorded, after[a].name) == nullptr);
    const bool is_gone = !is_new && (a == after.size() || before[b].name != after[a].name);
    // A measure that is new in the catalogue, and has no limit, was not recorded.
    const bool differs = is_new ? after[a].judged : is_gone || !is_equal(before[b], after[a]);
    if (differs) {
      differences.push_back({now.id, is_gone ? before[b].name : after[a].name,
                             is_new ? "none" : text_of(before[b]),
                             is_gone ? "none" : text_of(after[a])});
    }
    b += is_new ? 0 : 1;
    a += is_gone ? 0 : 1;
  }
  if (recorded.verdict != now.verdict) {
    differences.push_back({now.id, "verdict", to_string(recorded.verdict), to_string(now.verdict)});
  }
}

Rejudged judged_again(const std::string& path) {
  record::Reader reader(path);
  Rejudged again;
  again.run = reader.head();
  again.recorded = again.run.verdict;
  if (again.run.profile_text.empty()) {
    throw record::StoreError(path + ": cannot be judged again: " + again.run.verdict_reason);
  }
  const profile::Plan plan = judge::plan_of(again.run);
  const judge::Judge judge(plan, again.run);
  for (std::size_t i = 0; i < reader.outlets(); ++i) {
    record::OutletRecord outlet = reader.marked(i);
    const record::OutletRecord recorded = outlet;
    judge::Case c = judge.begin(outlet);
    reader.read_reports(i, [&](const record::Reports& piece) { c.add(piece); });
    judge.finish(c, outlet);
    compare(recorded, outlet, again.differences);
    outlet.reports = {};
    outlet.measurements.clear();
    again.run.outlets.push_back(std::move(outlet));
  }
  judge::conclude(again.run);
  if (again.run.verdict != again.recorded) {
    again.differences.push_back(
        {"", "verdict", to_string(again.recorded), to_string(again.run.verdict)});
  }
  return again;
}

nlohmann::ordered_json as_json(const Rejudged& again) {
  nlohmann::ordered_json out = {{"run_id", again.run.run_id},
                                {"gsbench_version", again.run.gsbench_version},
                                {"judged_by_version", installation::version()},
                                {"judged", is_judged(again.run)},
                                {"recorded_verdict", to_string(again.recorded)},
                                {"verdict", to_string(again.run.verdict)},
                                {"differences", nlohmann::ordered_json::array()}};
  for (const Difference& difference : again.differences) {
    out["differences"].push_back(
        {{"outlet", difference.outlet.empty() ? nlohmann::ordered_json(nullptr)
                                              : nlohmann::ordered_json(difference.outlet)},
         {"what", difference.what},
         {"recorded", difference.recorded},
         {"now", difference.now}});
  }
  return out;
}

constexpr std::size_t kMostPrinted = 30;

void print(const Rejudged& again) {
  std::vector<std::vector<std::string>> rows = {{"outlet", "measure", "recorded", "now"}};
  for (std::size_t i = 0; i < std::min(again.differences.size(), kMostPrinted); ++i) {
    const Difference& difference = again.differences[i];
    rows.push_back({difference.outlet.empty() ? "the run" : difference.outlet, difference.what,
                    difference.recorded, difference.now});
  }
  if (!again.differences.empty()) {
    for (const std::string& line : render::aligned(rows, "l")) {
      print_wrapped(line, 4);
    }
  }
  if (again.differences.size() > kMostPrinted) {
    std::printf("… and %zu more\n", again.differences.size() - kMostPrinted);
  }
  const std::size_t count = again.differences.size();
  const std::string how =
      count > 0               ? fmt::format("{} difference{}; the record is of gsbench {}", count,
                              count == 1 ? "" : "s", again.run.gsbench_version)
      : !is_judged(again.run) ? "as recorded; not judged: " + again.run.verdict_reason
                              : "as recorded: the verdicts and values of all outlets are the same";
  print_wrapped(fmt::format("{}, {}", to_string(again.run.verdict), how), 4);
}

int rejudge(const RejudgeArguments& arguments) {
  const Rejudged again = judged_again(find_record(arguments.run, arguments.output_folder));
  if (arguments.json) {
    print_json(as_json(again), record::kFormatVersion);
  } else {
    print(again);
  }
  return exit_code_of(again.run.verdict);
}

}  // namespace

void add_rejudge(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "rejudge", "Judge a kept run again, from its record alone, and compare the results", rejudge);
  command
      .add_option("RUN", arguments.run,
                  "Id of a run, its folder, or its record file; the start of an id is enough")
      ->type_name("RUN")
      ->required();
  add_runs_folder(command, arguments.output_folder);
  add_json_flag(command, arguments.json);
  command.footer(
      "The record has all that is needed: profile, grid, the played part of the recording, and "
      "what\n"
      "each outlet reported. It is not changed. The exit code is that of the new verdict.\n"
      "\n"
      "Example:\n  gsbench rejudge 20260101T120000Z-0123abcd");
}

}  // namespace gsbench::cli
