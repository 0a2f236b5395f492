#include "commands.hpp"
#include "run_folder.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <record/store.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

struct RunsArguments {
  std::string output_folder = default_runs_folder();
  bool json = false;
};

// In order of their start. A record that cannot be read is reported, and the others are still
// listed.
std::vector<record::RunRecord> heads_by_age(const std::string& output_folder) {
  std::vector<record::RunRecord> heads;
  for (const std::string& path : list_records(output_folder)) {
    try {
      heads.push_back(record::read_head(path));
    } catch (const record::StoreError& error) {
      print_error(error.what());
    }
  }
  std::sort(heads.begin(), heads.end(), [](const auto& a, const auto& b) {
    return std::tie(a.started_utc, a.run_id) < std::tie(b.started_utc, b.run_id);
  });
  return heads;
}

nlohmann::ordered_json as_json(const std::vector<record::RunRecord>& heads) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const record::RunRecord& run : heads) {
    all.push_back({{"run_id", run.run_id},
                   {"started_utc", run.started_utc},
                   {"profile", run.profile},
                   {"seed", run.seed},
                   {"verdict", record::to_string(run.verdict)}});
  }
  return all;
}

// The profile comes last, since its name may be long.
void print(const std::vector<record::RunRecord>& heads) {
  std::vector<std::vector<std::string>> rows = {{"run", "verdict", "seed", "profile"}};
  for (const record::RunRecord& run : heads) {
    rows.push_back(
        {run.run_id, record::to_string(run.verdict), std::to_string(run.seed), run.profile});
  }
  for (const std::string& line : render::aligned(rows, "llrl")) {
    print_wrapped(line, 4);
  }
}

int runs(const RunsArguments& arguments) {
  const std::vector<record::RunRecord> heads = heads_by_age(arguments.output_folder);
  for (const std::string& folder : list_unfinished(arguments.output_folder)) {
    print_error(fmt::format(
        "{0}: this run has not ended, or was killed; `gsbench report {0}` shows what it kept",
        folder));
  }
  if (arguments.json) {
    print_json(as_json(heads));
  } else if (!heads.empty()) {
    print(heads);
  }
  return kPassed;
}

}  // namespace

void add_runs(CommandLine& line) {
  const auto [command, arguments] = line.command("runs", "List kept runs, oldest first", runs);
  add_runs_folder(command, arguments.output_folder)->check(CLI::ExistingDirectory);
  add_json_flag(command, arguments.json);
  command.footer("Example:\n  gsbench runs");
}

}  // namespace gsbench::cli
