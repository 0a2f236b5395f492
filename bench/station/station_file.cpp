#include "station_kind.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <profile/files.hpp>

namespace gsbench::station {
namespace {

const StationKind& kind_of(const std::string& name) {
  return *std::find_if(station_kinds().begin(), station_kinds().end(),
                       [&](const StationKind& kind) { return kind.name == name; });
}

std::unique_ptr<StationFile> parse_station(const profile::NamedFile& file) {
  const keys::Document document = keys::parse_toml(profile::read_file(file.path), file.path);
  const keys::Table top(document, station_keys());
  const StationKind& kind = kind_of(top.text("kind"));
  for (const StationKind& other : station_kinds()) {
    for (const keys::Key& key : other.keys) {
      if (other.name != kind.name && top.has(key.name)) {
        top.refuse(top.at(key.name), fmt::format("{} means nothing to a station of kind \"{}\"",
                                                 key.name, kind.name));
      }
    }
  }
  std::unique_ptr<StationFile> station = kind.read(top, file.path);
  station->name = file.name;
  station->path = file.path;
  station->title = top.text("title");
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
    meaning += (meaning.empty() ? "" : "; ") + kind.meaning;
    own.insert(own.end(), kind.keys.begin(), kind.keys.end());
  }
  std::vector<keys::Key> all = {
      keys::text("title", "one line for lists").require(),
      keys::word("kind", names, meaning).require("kind = " + alternatives(names))};
  all.insert(all.end(), own.begin(), own.end());
  return keys::table("a station", "", std::move(all));
}

}  // namespace

const keys::Key& station_keys() {
  static const keys::Key keys = declared();
  return keys;
}

std::unique_ptr<StationFile> load_station(const std::string& name) {
  return parse_station(profile::find_station(name));
}

std::vector<profile::ProfileSummary> list_stations() {
  return profile::summaries_of(profile::all_stations(), [](const profile::NamedFile& file) {
    return parse_station(file)->title;
  });
}

}  // namespace gsbench::station
