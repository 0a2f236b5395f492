#include "commands.hpp"

#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

void list(bool json) {
  const std::vector<profile::ProfileSummary> profiles = profile::list_profiles();
  const std::vector<std::string> grids = profile::list_grids();
  if (json) {
    nlohmann::ordered_json out;
    out["profiles"] = nlohmann::ordered_json::array();
    for (const profile::ProfileSummary& summary : profiles) {
      out["profiles"].push_back({{"name", summary.name}, {"title", summary.title}});
    }
    out["grids"] = grids;
    std::printf("%s\n", out.dump(2).c_str());
    return;
  }
  std::puts("Profiles");
  for (const profile::ProfileSummary& summary : profiles) {
    std::printf("  %-28s %s\n", summary.name.c_str(), summary.title.c_str());
  }
  std::puts("Grids");
  for (const std::string& grid : grids) {
    std::printf("  %s\n", grid.c_str());
  }
}

}  // namespace

void add_list(CLI::App& app, int&) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("list", "The shipped profiles and grids");
  command->add_flag("--json", *json, "Print as JSON");
  command->footer("Example:\n  gsbench list");
  command->callback([json] { list(*json); });
}

}  // namespace gsbench::cli
