#include "station_kind.hpp"

#include <fmt/format.h>

#include <profile/files.hpp>

namespace gsbench::station {
namespace {

const std::vector<StationKind>& station_kinds() {
  static const std::vector<StationKind> kinds = {simulated_kind(), emulated_kind(),
                                                 physical_kind()};
  return kinds;
}

StationFile parse_station(const profile::NamedFile& file) {
  const keys::Document document = keys::parse_toml(profile::read_file(file.path), file.path);
  const keys::Table top(document, station_keys());
  StationFile station = {file.name, top.text("title"), file.path};
  const std::string of_kind = top.text("kind");
  for (const StationKind& kind : station_kinds()) {
    if (kind.name == of_kind) {
      continue;
    }
    for (const keys::Key& key : kind.keys) {
      if (top.has(key.name)) {
        top.refuse(key.name,
                   fmt::format("{} is not a key of a station of kind \"{}\"", key.name, of_kind));
      }
    }
  }
  for (const StationKind& kind : station_kinds()) {
    if (kind.name == of_kind) {
      kind.read(top, station);
    }
  }
  return station;
}

// "a, b or c".
std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + ('"' + names[i] + '"');
  }
  return text;
}

keys::Key declared() {
  std::vector<std::string> names;
  std::string meaning;
  std::vector<keys::Key> own;
  for (const StationKind& kind : station_kinds()) {
    names.push_back(kind.name);
    meaning += (meaning.empty() ? "`" : "; `") + kind.name + "`: " + kind.meaning;
    own.insert(own.end(), kind.keys.begin(), kind.keys.end());
  }
  std::vector<keys::Key> all = {
      keys::text("title", "title in lists, one line").require(),
      keys::choice("kind", names, meaning).require("kind = " + alternatives(names))};
  all.insert(all.end(), own.begin(), own.end());
  return keys::table("a station", "", std::move(all));
}

}  // namespace

const keys::Key& station_keys() {
  static const keys::Key keys = declared();
  return keys;
}

StationFile load_station(const std::string& name) {
  return parse_station(profile::find_station(name));
}

std::vector<profile::ProfileSummary> list_stations() {
  return profile::summaries_of(profile::all_stations(), [](const profile::NamedFile& file) {
    return parse_station(file).title;
  });
}

profile::Plan fit_to_station(const StationFile& station, const profile::Plan& plan) {
  const std::size_t available = station.outlets.value_or(plan.outlets.size());
  if (available >= plan.outlets.size()) {
    return plan;
  }
  const std::vector<std::string> groups = profile::groups_of(plan.outlets);
  if (groups.size() > available) {
    throw profile::ConfigurationError(plan.path + ": has " + std::to_string(groups.size()) +
                                      " groups of outlets; the station " + station.name +
                                      " has only " + std::to_string(available) + " outlets");
  }
  // Round robin over the groups.
  std::vector<bool> taken(plan.outlets.size(), false);
  for (std::size_t chosen = 0; chosen < available;) {
    for (const std::string& group : groups) {
      for (std::size_t i = 0; i < plan.outlets.size() && chosen < available; ++i) {
        if (!taken[i] && plan.outlets[i].group == group) {
          taken[i] = true;
          ++chosen;
          break;
        }
      }
    }
  }
  profile::Plan fitted = plan;
  fitted.outlets.clear();
  for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
    if (taken[i]) {
      fitted.outlets.push_back(plan.outlets[i]);
    }
  }
  return fitted;
}

}  // namespace gsbench::station
