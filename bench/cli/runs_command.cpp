#include "commands.hpp"
#include "run_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

#include <record/store.hpp>

namespace gsbench::cli {
namespace {

struct RunsArguments {
  std::string output_folder = default_runs_folder();
  bool json = false;
};

// By their beginning, the oldest first. What cannot be read is told, and the others still listed.
std::vector<record::RunRecord> heads_by_age(const std::string& output_folder) {
  std::vector<record::RunRecord> heads;
  for (const std::string& path : list_records(output_folder)) {
    try {
      heads.push_back(record::read_head(path));
    } catch (const record::StoreError& error) {
      std::fprintf(stderr, "gsbench: %s\n", error.what());
    }
  }
  std::sort(heads.begin(), heads.end(), [](const auto& a, const auto& b) {
    return std::tie(a.started_utc, a.run_id) < std::tie(b.started_utc, b.run_id);
  });
  return heads;
}

int runs(const RunsArguments& arguments) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const record::RunRecord& run : heads_by_age(arguments.output_folder)) {
    if (arguments.json) {
      out.push_back({{"run_id", run.run_id},
                     {"started_utc", run.started_utc},
                     {"profile", run.profile},
                     {"seed", run.seed},
                     {"verdict", record::to_string(run.verdict)}});
    } else {
      std::printf("%-28s %-12s %s (seed %llu)\n", run.run_id.c_str(),
                  record::to_string(run.verdict), run.profile.c_str(),
                  static_cast<unsigned long long>(run.seed));
    }
  }
  for (const std::string& folder : list_unfinished(arguments.output_folder)) {
    std::fprintf(stderr,
                 "gsbench: %s: a run that has not ended, or was killed; `gsbench report` shows "
                 "what it kept\n",
                 folder.c_str());
  }
  if (arguments.json) {
    print_json(out);
  }
  return kPassed;
}

}  // namespace

void add_runs(CommandLine& line) {
  const auto [command, arguments] =
      line.command("runs", "The runs that are kept, oldest first", runs);
  add_runs_folder(command, arguments.output_folder)->check(CLI::ExistingDirectory);
  command.add_flag("--json", arguments.json, "Print as JSON");
  command.footer("Example:\n  gsbench runs");
}

}  // namespace gsbench::cli
