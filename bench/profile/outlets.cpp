#include "outlets.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

constexpr std::int64_t kMostOutlets = 1000;  // of one run; studies of more have no profile
constexpr std::size_t kLongestId = 64;

// What outlets accept of their settings (outlet/settings.hpp), told here by line and key.
constexpr double kLowestSwitchOff_pu = 0.8;
constexpr double kLeastPower_mw = 1e-6;  // as of a grid's powers: past these it is another unit
constexpr double kMostPower_mw = 1e7;
constexpr double kLargestDrop_hz = 1.0;
constexpr int kMostHits = 1000;
constexpr int kMostLseSamples = 64;
constexpr int kMostEkfSamples = 200;

std::optional<int> read_count(const Table& table, const std::string& key, int least, int most) {
  const auto value = table.integer(key, least, most);
  return value ? std::optional<int>(static_cast<int>(*value)) : std::nullopt;
}

control_centre::Wishes read_settings(const Table& table, const grid::Grid& grid) {
  control_centre::Wishes settings;
  Range load = between(0.0, grid.load_mw);
  load.note = "the grid's load";
  settings.accumulated_mw = table.number("accumulated_mw", load).value_or(0.0);
  Range block = above(0.0);
  block.high = 2.0 * settings.accumulated_mw;
  block.note = "twice accumulated_mw, which counts half of the outlet's own block";
  settings.power_mw = table.number("power_mw", block);
  settings.threshold_mw = table.number("threshold_mw", between(kLeastPower_mw, kMostPower_mw));
  Range below_nominal = between(kLowestSwitchOff_pu * grid.nominal_hz, grid.nominal_hz);
  below_nominal.high_open = true;
  below_nominal.note = "the grid's nominal_hz";
  settings.switch_off_hz = table.number("switch_off_hz", below_nominal);
  if (settings.switch_off_hz &&
      !(static_cast<float>(*settings.switch_off_hz) < static_cast<float>(grid.nominal_hz))) {
    table.refuse("switch_off_hz", fmt::format("switch_off_hz is {}; in the outlets' single "
                                              "precision that is nominal_hz itself",
                                              *settings.switch_off_hz));
  }
  Range drop = above(0.0);
  drop.high = kLargestDrop_hz;
  settings.event_drop_hz = table.number("event_drop_hz", drop);
  settings.event_departure_hz = table.number("event_departure_hz", drop);
  settings.condition_hits = read_count(table, "condition_hits", 0, kMostHits);
  settings.lse_samples = read_count(table, "lse_samples", 2, kMostLseSamples);  // a slope takes two
  settings.ekf_samples = read_count(table, "ekf_samples", 1, kMostEkfSamples);
  return settings;
}

}  // namespace

std::vector<Outlet> read_outlets(const Table& top, const grid::Grid& grid) {
  std::vector<Outlet> outlets;
  for (const Value* value : top.tables("outlet")) {
    const Table table(
        top.document(), *value, "[[outlet]]",
        {"count", "id", "group", "accumulated_mw", "power_mw", "threshold_mw", "switch_off_hz",
         "event_drop_hz", "event_departure_hz", "condition_hits", "lse_samples", "ekf_samples"});
    const std::int64_t count = table.integer("count", 1, kMostOutlets).value_or(1);
    const auto prefix = table.identifier("id", kLongestId);
    const std::string group =
        table.identifier("group", kLongestId).value_or(prefix.value_or("all"));
    const control_centre::Wishes settings = read_settings(table, grid);
    try {
      control_centre::outlet_settings(grid, settings, 1);
    } catch (const std::invalid_argument& error) {
      table.refuse(table.at(), error.what());
    }
    if (outlets.size() + static_cast<std::size_t>(count) > kMostOutlets) {
      table.refuse(table.at(), fmt::format("more than {} outlets in all", kMostOutlets));
    }
    for (std::int64_t i = 1; i <= count; ++i) {
      // Outlets without an id of their own are numbered through the whole profile.
      const std::string id = !prefix      ? fmt::format("outlet-{}", outlets.size() + 1)
                             : count == 1 ? *prefix
                                          : fmt::format("{}-{}", *prefix, i);
      const auto same = [&](const Outlet& other) { return other.id == id; };
      if (std::any_of(outlets.begin(), outlets.end(), same)) {
        table.refuse(
            prefix ? table.at("id") : table.at(),
            fmt::format("there is an outlet \"{}\" already; give this one another id", id));
      }
      outlets.push_back({id, group, settings});
    }
  }
  if (outlets.empty()) top.refuse_missing("outlet", "at least one [[outlet]]");
  return outlets;
}

std::vector<std::string> groups_of(const std::vector<Outlet>& outlets) {
  std::vector<std::string> groups;
  for (const Outlet& outlet : outlets) {
    if (std::find(groups.begin(), groups.end(), outlet.group) == groups.end()) {
      groups.push_back(outlet.group);
    }
  }
  return groups;
}

}  // namespace gsbench::profile
