#include "station_kind.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include <profile/files.hpp>

namespace gsbench::station {
namespace {

const std::vector<StationKind>& station_kinds() {
  static const std::vector<StationKind> kinds = {simulated_kind(), emulated_kind(),
                                                 physical_kind()};
  return kinds;
}

// "a, b or c".
std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + ('"' + names[i] + '"');
  }
  return text;
}

keys::Key declared(const std::vector<std::string>& kinds, const std::string& kind_meaning,
                   const std::vector<keys::Key>& own) {
  std::vector<keys::Key> all = {
      keys::text("title", "title in lists, one line").require(),
      keys::choice("kind", kinds, kind_meaning).require("kind = " + alternatives(kinds))};
  all.insert(all.end(), own.begin(), own.end());
  return keys::table("a station", "", std::move(all));
}

// For a file whose kind is missing or wrong.
const keys::Key& keys_of_no_kind() {
  static const keys::Key keys = [] {
    std::vector<std::string> names;
    std::vector<keys::Key> all;
    for (const StationKind& kind : station_kinds()) {
      names.push_back(kind.name);
      for (const keys::Key& key : kind.keys) {
        if (std::none_of(all.begin(), all.end(),
                         [&](const keys::Key& known) { return known.name == key.name; })) {
          all.push_back(key);
        }
      }
    }
    return declared(names, "", all);
  }();
  return keys;
}

const StationKind* kind_of(const keys::Document& document) {
  for (const keys::Entry& entry : std::get<keys::Entries>(document.root.data)) {
    const auto* name = std::get_if<std::string>(&entry.value.data);
    for (const StationKind& kind : station_kinds()) {
      if (entry.key == "kind" && name != nullptr && *name == kind.name) {
        return &kind;
      }
    }
  }
  return nullptr;
}

bool has_key(const std::vector<keys::Key>& declared, const std::string& name) {
  return std::any_of(declared.begin(), declared.end(),
                     [&](const keys::Key& key) { return key.name == name; });
}

void refuse_keys_of_other_kinds(const keys::Document& document, const StationKind& own) {
  for (const keys::Entry& entry : std::get<keys::Entries>(document.root.data)) {
    for (const StationKind& kind : station_kinds()) {
      if (!has_key(own.keys, entry.key) && has_key(kind.keys, entry.key)) {
        throw keys::error_at(
            document.path, entry.value.at,
            fmt::format("{} is not a key of a station of kind \"{}\"", entry.key, own.name));
      }
    }
  }
}

StationFile parse_station(const profile::NamedFile& file) {
  const std::string text = profile::read_file(file.path);
  const keys::Document document = keys::parse_toml(text, file.path);
  const StationKind* kind = kind_of(document);
  if (kind == nullptr) {
    const keys::Table refused(document, keys_of_no_kind());
    refused.refuse_missing("kind", keys_of_no_kind().inner[1].remedy);
  }
  refuse_keys_of_other_kinds(document, *kind);
  const keys::Table top(document, station_keys(kind->name));
  StationFile station = {file.name, top.text("title"), file.path, text};
  kind->read(top, station);
  return station;
}

}  // namespace

const keys::Key& station_keys(const std::string& kind) {
  static const auto by_kind = [] {
    std::map<std::string, keys::Key> all;
    for (const StationKind& known : station_kinds()) {
      all.emplace(known.name, declared({known.name}, known.meaning, known.keys));
    }
    return all;
  }();
  return by_kind.at(kind);
}

std::vector<std::string> station_kind_names() {
  std::vector<std::string> names;
  for (const StationKind& kind : station_kinds()) {
    names.push_back(kind.name);
  }
  return names;
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
                                      " has only " + std::to_string(available) +
                                      (available == 1 ? " outlet" : " outlets"));
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
