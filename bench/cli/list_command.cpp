#include "commands.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <profile/load.hpp>
#include <station/station_file.hpp>

namespace gsbench::cli {
namespace {

nlohmann::ordered_json as_json(const std::vector<profile::ProfileSummary>& summaries) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const profile::ProfileSummary& summary : summaries) {
    all.push_back({{"name", summary.name}, {"title", summary.title}});
  }
  return all;
}

void print(const char* heading, const std::vector<profile::ProfileSummary>& summaries) {
  constexpr std::size_t kNameColumns = 28;
  std::puts(heading);
  for (const profile::ProfileSummary& summary : summaries) {
    print_wrapped(fmt::format("  {:<{}} {}", summary.name, kNameColumns, summary.title),
                  kNameColumns + 3);
  }
}

int list(const bool& json) {
  const std::vector<profile::ProfileSummary> profiles = profile::list_profiles();
  const std::vector<profile::ProfileSummary> grids = profile::list_grids();
  const std::vector<profile::ProfileSummary> stations = station::list_stations();
  if (json) {
    nlohmann::ordered_json out;
    out["profiles"] = as_json(profiles);
    out["grids"] = nlohmann::ordered_json::array();
    for (const profile::ProfileSummary& grid : grids) {
      out["grids"].push_back(grid.name);
    }
    out["stations"] = as_json(stations);
    print_json(out);
    return kPassed;
  }
  print("Profiles", profiles);
  print("Grids", grids);
  print("Stations", stations);
  return kPassed;
}

}  // namespace

void add_list(CommandLine& line) {
  const auto [command, arguments] = line.command("list", "List profiles, grids and stations", list);
  add_json_flag(command, arguments);
  command.footer("Example:\n  gsbench list");
}

}  // namespace gsbench::cli
