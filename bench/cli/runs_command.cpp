#include "commands.hpp"
#include "run_folder.hpp"

#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include <record/store.hpp>

namespace gsbench::cli {
namespace {

struct RunsArguments {
  std::string output_folder = "runs";
  bool json = false;
};

void runs(const RunsArguments& arguments) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const std::string& path : list_records(arguments.output_folder)) {
    record::RunRecord run;
    try {
      run = record::read_run(path);
    } catch (const record::StoreError& error) {
      // The others can still be listed.
      std::fprintf(stderr, "gsbench: %s\n", error.what());
      continue;
    }
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
    std::fprintf(
        stderr,
        "gsbench: %s: a run that has not ended, or was killed; `gsbench report` shows what "
        "it kept\n",
        folder.c_str());
  }
  if (arguments.json) {
    std::printf("%s\n", out.dump(2).c_str());
  }
}

}  // namespace

void add_runs(CLI::App& app, int&) {
  auto arguments = std::make_shared<RunsArguments>();
  CLI::App* command = app.add_subcommand("runs", "The runs that are kept, oldest first");
  command->add_option("--out", arguments->output_folder, "Folder that keeps the runs")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print as JSON");
  command->footer("Example:\n  gsbench runs");
  command->callback([arguments] { runs(*arguments); });
}

}  // namespace gsbench::cli
