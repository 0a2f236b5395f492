#include "sections.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Range;
using keys::Table;

constexpr std::int64_t kMostOutlets = 1000;  // in one run; larger studies do not use profiles
constexpr std::size_t kLongestId = 64;
constexpr const char* kPaperRules = "paper";
constexpr const char* kGsbenchRules = "gsbench";
constexpr const char* kOpenLoopRules = "open-loop";

control_centre::RequestedSettings read_requested(const Table& table, const grid::Grid& grid) {
  control_centre::RequestedSettings requested;
  const Range load = {0.0, grid.load_mw, false, false, "the grid's load"};
  requested.accumulated_mw = table.number("accumulated_mw", load);
  const Range block = {0.0, 2.0 * requested.accumulated_mw, true, false,
                       "twice accumulated_mw, which includes half of the outlet's own block"};
  requested.power_mw = table.find_number("power_mw", block);
  const std::string rules = table.text("rules");
  requested.rules =
      rules == kPaperRules ? control_centre::Rules::kPaper : control_centre::Rules::kGsbench;
  requested.staged_backup = rules == kGsbenchRules;
  read_settings(table, grid.nominal_hz, requested.settings);
  return requested;
}

}  // namespace

Key outlet_keys() {
  Key outlets = keys::tables(
      "outlet",
      "The outlets under test; at least one. Omitted settings are derived from the grid by the "
      "control centre, or keep the firmware's default.",
      {keys::whole("count", "", 1, kMostOutlets, "number of outlets with these settings")
           .permits("1 … 1000 in total")
           .by_default(1),
       keys::id("id", kLongestId,
                "name of the outlet; with `count` above 1 the names are `id-1`, `id-2`, …")
           .or_else("`outlet-N`"),
       keys::id("group", kLongestId, "name by which limits and commands refer to these outlets")
           .permits("as `id`")
           .or_else("`id`, or `all` without an id"),
       keys::number("accumulated_mw", "MW", keys::at_least(0.0),
                    "P^A: load that is shed before the outlet, plus half of its own block (for "
                    "eq. (11) as printed: plus the whole block)")
           .permits("0 … the grid's load")
           .by_default(0.0),
       keys::number("power_mw", "MW", keys::above(0.0),
                    "load of the outlet's own block, for eq. (17) alone; `accumulated_mw` includes "
                    "half of it. The default assumes one block as large as `accumulated_mw`, the "
                    "only load that is known. If `accumulated_mw` is 0, f^B is `threshold_hz`")
           .permits("above 0, at most twice `accumulated_mw`")
           .or_else("`accumulated_mw`"),
       keys::choice(
           "rules", {kOpenLoopRules, kGsbenchRules, kPaperRules},
           "how the control centre derives threshold loss and f^B: `gsbench`, such that "
           "the outlets' delay is allowed for, and in stages over `accumulated_mw`; "
           "`paper`, by eq. (15) and eq. (17); `open-loop`, the threshold loss as `gsbench` "
           "and f^B as `paper`, because a played frequency does not react to what is "
           "shed, and falls through stages at which a fleet would stop it")
           .by_default(kOpenLoopRules)});
  for (Key& key : setting_keys()) {
    outlets.inner.push_back(std::move(key));
  }
  return outlets.require("at least one [[outlet]]");
}

std::vector<Outlet> read_outlets(const Table& top, const grid::Grid& grid) {
  std::vector<Outlet> outlets;
  for (const Table& table : top.tables("outlet")) {
    const std::int64_t count = table.whole("count");
    const auto prefix = table.find_text("id");
    const std::string group = table.find_text("group").value_or(prefix.value_or("all"));
    const control_centre::RequestedSettings settings = read_requested(table, grid);
    try {
      control_centre::outlet_settings(grid, settings, 1);
    } catch (const std::invalid_argument& error) {
      table.refuse(table.at(), error.what());
    }
    if (outlets.size() + static_cast<std::size_t>(count) > kMostOutlets) {
      table.refuse(table.at(),
                   fmt::format("{} outlets in total; a profile has at most {}",
                               outlets.size() + static_cast<std::size_t>(count), kMostOutlets));
    }
    for (std::int64_t i = 1; i <= count; ++i) {
      // Outlets without an id are numbered throughout the profile.
      const std::string id = !prefix      ? fmt::format("outlet-{}", outlets.size() + 1)
                             : count == 1 ? *prefix
                                          : fmt::format("{}-{}", *prefix, i);
      const auto same = [&](const Outlet& other) { return other.id == id; };
      if (std::any_of(outlets.begin(), outlets.end(), same)) {
        table.refuse(prefix ? table.at("id") : table.at(),
                     fmt::format("two outlets have the id \"{}\"; give this one another id", id));
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
