#include "sections.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::Range;
using keys::Table;

// Each one holds the settings of all its outlets.
constexpr std::size_t kMostUpdates = 100;
// As for the first settings, the outlets must have time to acknowledge.
constexpr double kBeforeTheEnd_s = kShortestRun_s;

void change(const Table& table, const grid::Grid& grid,
            control_centre::RequestedSettings& settings) {
  const Range load = {0.0, grid.load_mw, false, false, "the grid's load"};
  settings.accumulated_mw =
      table.find_number("accumulated_mw", load).value_or(settings.accumulated_mw);
  if (const auto power_mw = table.find_number("power_mw")) {
    settings.power_mw = power_mw;
  }
  read_settings(table, grid.nominal_hz, settings.settings);
  if (settings.power_mw && *settings.power_mw > 2.0 * settings.accumulated_mw) {
    table.refuse(table.has("power_mw") ? "power_mw" : "accumulated_mw",
                 fmt::format("power_mw is {} and accumulated_mw is {}; power_mw must be at most "
                             "twice accumulated_mw, which includes half of the outlet's own block",
                             *settings.power_mw, settings.accumulated_mw));
  }
}

bool equal(const control_centre::RequestedSettings& a, const control_centre::RequestedSettings& b) {
  return a.accumulated_mw == b.accumulated_mw && a.power_mw == b.power_mw &&
         a.settings == b.settings && a.rules == b.rules && a.staged_backup == b.staged_backup;
}

void check(const Table& table, const grid::Grid& grid, const SettingsUpdate& update) {
  const control_centre::RequestedSettings* checked = nullptr;
  for (const auto& [id, settings] : update.outlets) {
    if (checked != nullptr && equal(*checked, settings)) {
      continue;  // outlets of a group have the same, and deriving them from the grid takes time
    }
    try {
      control_centre::outlet_settings(grid, settings, 1);
    } catch (const std::invalid_argument& error) {
      table.refuse(table.at(), error.what());
    }
    checked = &settings;
  }
}

// "accumulated_mw = 120, threshold_mw = 300"; empty without changes.
std::string changes_of(const Table& table, const keys::Key& keys) {
  std::string text;
  for (const keys::Key& key : keys.inner) {
    if (keys::is_number(key) && key.name != "at_s" && table.has(key.name)) {
      const double value = key.type == keys::Type::kWhole
                               ? static_cast<double>(table.whole(key.name))
                               : table.number(key.name);
      text += fmt::format("{}{} = {:g}", text.empty() ? "" : ", ", key.name, value);
    }
  }
  return text;
}

Range before_end(double duration_s) {
  return {0.0, duration_s - kBeforeTheEnd_s, false, false,
          "0.1 s before the end of the run, so that they can be acknowledged"};
}

}  // namespace

keys::Key settings_update_keys() {
  keys::Key updates = keys::tables(
      "settings",
      "Settings that the control centre sends again during the run, with the next version number. "
      "Without other keys the outlets get the same as before. A change also holds for those that "
      "are sent later. An outlet that refuses them, or does not acknowledge them within 1 s, is "
      "faulty. Reports list the settings that were sent first.",
      {keys::number("at_s", "s", keys::at_least(0.0), "time at which the control centre sends them")
           .permits("0 … 0.1 s before the end of the run; at most 100 times")
           .require(),
       keys::array("outlets", keys::text("", ""), "recipients of the settings")
           .permits("array of groups or ids")
           .or_else("all"),
       keys::number("accumulated_mw", "MW", keys::at_least(0.0), "P^A, as for `[[outlet]]`")
           .permits("0 … the grid's load")
           .or_else("unchanged"),
       keys::number("power_mw", "MW", keys::above(0.0),
                    "load of the outlet's own block, as for `[[outlet]]`")
           .permits("above 0, at most twice `accumulated_mw`")
           .or_else("unchanged")});
  for (const keys::Key& key : setting_keys()) {
    updates.inner.push_back(key.or_else("unchanged"));
  }
  return updates;
}

std::vector<SettingsUpdate> read_settings_updates(const Table& top, const grid::Grid& grid,
                                                  const std::vector<Outlet>& outlets,
                                                  double duration_s) {
  std::vector<Table> tables = top.tables("settings");
  if (tables.size() > kMostUpdates) {
    top.refuse(tables[kMostUpdates].at(),
               fmt::format("settings are sent {} times; a profile sends them at most {} times",
                           tables.size(), kMostUpdates));
  }
  const auto at_s = [&](const Table& table) {
    return table.number("at_s", before_end(duration_s));
  };
  std::stable_sort(tables.begin(), tables.end(),
                   [&](const Table& a, const Table& b) { return at_s(a) < at_s(b); });
  std::vector<Outlet> now = outlets;
  std::vector<SettingsUpdate> updates;
  for (const Table& table : tables) {
    SettingsUpdate& update = updates.emplace_back();
    update.at_s = at_s(table);
    update.changes = changes_of(table, settings_update_keys());
    const std::vector<std::string> ids = named_outlets(table, outlets);
    for (Outlet& outlet : now) {
      if (ids.empty() || std::find(ids.begin(), ids.end(), outlet.id) != ids.end()) {
        change(table, grid, outlet.settings);
        update.outlets.emplace(outlet.id, outlet.settings);
      }
    }
    check(table, grid, update);
  }
  return updates;
}

}  // namespace gsbench::profile
