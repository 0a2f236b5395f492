#include "outlets.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/limits.hpp>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Range;
using keys::Table;

constexpr std::int64_t kMostOutlets = 1000;  // of one run; studies of more have no profile
constexpr std::size_t kLongestId = 64;

// What outlets accept of their settings (outlet/settings.hpp), told here by line and key.
constexpr double kLowestSwitchOff_pu = 0.8;
constexpr double kLargestDrop_hz = 1.0;
constexpr int kMostHits = 1000;
constexpr int kMostLseSamples = 64;
constexpr int kMostEkfSamples = 200;

std::optional<int> find_count(const Table& table, const std::string& key) {
  const auto value = table.find_whole(key);
  return value ? std::optional<int>(static_cast<int>(*value)) : std::nullopt;
}

control_centre::Wishes read_settings(const Table& table, const grid::Grid& grid) {
  control_centre::Wishes settings;
  Range load = keys::between(0.0, grid.load_mw);
  load.note = "the grid's load";
  settings.accumulated_mw = table.number("accumulated_mw", load);
  Range block = keys::above(0.0);
  block.high = 2.0 * settings.accumulated_mw;
  block.note = "twice accumulated_mw, which counts half of the outlet's own block";
  settings.power_mw = table.find_number("power_mw", block);
  settings.threshold_mw = table.find_number("threshold_mw");
  Range below_nominal = keys::between(kLowestSwitchOff_pu * grid.nominal_hz, grid.nominal_hz);
  below_nominal.high_open = true;
  below_nominal.note = "the grid's nominal_hz";
  settings.switch_off_hz = table.find_number("switch_off_hz", below_nominal);
  if (settings.switch_off_hz &&
      !(static_cast<float>(*settings.switch_off_hz) < static_cast<float>(grid.nominal_hz))) {
    table.refuse("switch_off_hz", fmt::format("switch_off_hz is {}; in the outlets' single "
                                              "precision that is nominal_hz itself",
                                              *settings.switch_off_hz));
  }
  settings.event_drop_hz = table.find_number("event_drop_hz");
  settings.event_departure_hz = table.find_number("event_departure_hz");
  settings.condition_hits = find_count(table, "condition_hits");
  settings.lse_samples = find_count(table, "lse_samples");
  settings.ekf_samples = find_count(table, "ekf_samples");
  return settings;
}

}  // namespace

Key outlet_keys() {
  Range drop = keys::above(0.0);
  drop.high = kLargestDrop_hz;
  const char* const firmware = "firmware's";
  return keys::tables(
             "outlet",
             "At least one. What is left out the control centre derives from the grid, or the "
             "firmware's default stands.",
             {keys::whole("count", "", 1, kMostOutlets, "so many alike")
                  .permits("1 … 1000 in all")
                  .by_default(1),
              keys::id("id", kLongestId,
                       "its name; with `count` above 1 the names are `id-1`, `id-2`, …")
                  .or_else("`outlet-N`"),
              keys::id("group", kLongestId, "what limits and commands refer to")
                  .permits("as `id`")
                  .or_else("`id`; without: `all`"),
              keys::number("accumulated_mw", "MW", keys::at_least(0.0),
                           "P^A as sent: load that is shed before it and half of its own block "
                           "(all of it where "
                           "you want eq. (11) as printed)")
                  .permits("0 … the grid's load")
                  .by_default(0.0),
              keys::number(
                  "power_mw", "MW", keys::above(0.0),
                  "power of its own block, for eq. (17); half of it is taken to be counted in "
                  "`accumulated_mw`")
                  .permits("above 0, at most twice `accumulated_mw`")
                  .or_else("`accumulated_mw`"),
              keys::number("threshold_mw", "MW",
                           keys::between(grid::kPowerMw.low, grid::kPowerMw.high), "ΔP_s")
                  .or_else("eq. (15)"),
              keys::number("switch_off_hz", "Hz", keys::above(0.0), "f^B")
                  .permits("0.8 of nominal … below nominal, in single precision too")
                  .or_else("eq. (17)"),
              keys::number("event_drop_hz", "Hz", drop,
                           "least sum of the successive drops that make an event")
                  .or_else(firmware),
              keys::number("event_departure_hz", "Hz", drop,
                           "least fall below the course before, for the same")
                  .or_else(firmware),
              keys::whole("condition_hits", "", 0, kMostHits,
                          "n_max: more hits than this are needed to shed")
                  .or_else(firmware),
              keys::whole("lse_samples", "", 2, kMostLseSamples,
                          "measurements in the least squares, eq. (19)")
                  .or_else(firmware),
              keys::whole("ekf_samples", "", 1, kMostEkfSamples,
                          "measurements in the Kalman filter before the decision")
                  .or_else(firmware)})
      .require("at least one [[outlet]]");
}

std::vector<Outlet> read_outlets(const Table& top, const grid::Grid& grid) {
  std::vector<Outlet> outlets;
  for (const Table& table : top.tables("outlet")) {
    const std::int64_t count = table.whole("count");
    const auto prefix = table.find_text("id");
    const std::string group = table.find_text("group").value_or(prefix.value_or("all"));
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
