#include "commands.hpp"
#include "run_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <record/store.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

struct RunsArguments {
  std::string output_folder = default_runs_folder();
  bool json = false;
};

struct KeptRun {
  std::string name;  // its id; the name of its folder if no id was stored
  record::RunRecord head;
  bool in_progress;

  // A run in progress has none yet.
  const char* verdict() const { return in_progress ? nullptr : record::to_string(head.verdict); }
  const char* state() const {
    return in_progress                  ? "in progress"
           : !head.finished_utc.empty() ? "finished"
                                        : "unfinished";  // its process was killed
  }
};

// In order of their start. A record that cannot be read is reported, and the others are still
// listed.
std::vector<KeptRun> runs_by_age(const std::string& output_folder) {
  std::vector<std::string> records = list_records(output_folder);
  for (const std::string& folder : list_unfinished(output_folder)) {
    records.push_back(folder + "/" + kRecordFile);
  }
  std::vector<KeptRun> kept;
  for (const std::string& path : records) {
    try {
      refuse_empty_record(path);
      const bool in_progress = record::is_in_progress(path);
      record::RunRecord head = record::read_head(path);
      const std::string folder = std::filesystem::path(path).parent_path().filename().string();
      kept.push_back({head.run_id.empty() ? folder : head.run_id, std::move(head), in_progress});
    } catch (const record::StoreError& error) {
      print_error(error.what());
    }
  }
  std::sort(kept.begin(), kept.end(), [](const KeptRun& a, const KeptRun& b) {
    return std::tie(a.head.started_utc, a.name) < std::tie(b.head.started_utc, b.name);
  });
  return kept;
}

nlohmann::ordered_json as_json(const std::vector<KeptRun>& kept) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const KeptRun& run : kept) {
    all.push_back({{"run_id", run.name},
                   {"started_utc", run.head.started_utc},
                   {"state", run.state()},
                   {"profile", run.head.profile},
                   {"seed", run.head.seed},
                   {"verdict", run.verdict() == nullptr ? nlohmann::ordered_json()
                                                        : nlohmann::ordered_json(run.verdict())}});
  }
  return all;
}

// An id begins with the time of the start. The profile comes last, since its name may be long.
void print(const std::vector<KeptRun>& kept) {
  std::vector<std::vector<std::string>> rows = {{"run", "state", "verdict", "seed", "profile"}};
  for (const KeptRun& run : kept) {
    rows.push_back({run.name, run.state(), run.verdict() == nullptr ? "-" : run.verdict(),
                    std::to_string(run.head.seed), run.head.profile});
  }
  for (const std::string& line : render::aligned(rows, "lllrl")) {
    print_wrapped(line, 4);
  }
}

int runs(const RunsArguments& arguments) {
  const std::vector<KeptRun> kept = runs_by_age(arguments.output_folder);
  if (arguments.json) {
    print_json(as_json(kept), record::kFormatVersion);
  } else if (!kept.empty()) {
    print(kept);
  }
  return kPassed;
}

}  // namespace

void add_runs(CommandLine& line) {
  const auto [command, arguments] = line.command("runs", "List kept runs, oldest first", runs);
  add_runs_folder(command, arguments.output_folder)->check(CLI::ExistingDirectory);
  add_json_flag(command, arguments.json);
  command.footer(
      "A run is unfinished if it was killed; `gsbench report RUN` shows what it kept.\n"
      "\n"
      "Example:\n  gsbench runs");
}

}  // namespace gsbench::cli
