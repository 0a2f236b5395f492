#include "files.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include <fmt/format.h>

#include <boards/boards.hpp>
#include <keys/suggestion.hpp>
#include <keys/table.hpp>
#include <profile/station_spec.hpp>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Table;
using keys::Word;

namespace fs = std::filesystem;

constexpr double kMostPpm = 1000.0;
constexpr std::size_t kMostEmulated = 64;  // processes of one desk
constexpr std::size_t kLongestId = 32;     // that an outlet can say
constexpr const char* kBenchUser = "bench";

fs::path stations_folder() {
  return fs::path(profiles_folder()) / "stations";
}

std::vector<NamedFile> all_stations() {
  std::vector<NamedFile> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(stations_folder(), ignored)) {
    if (entry.path().extension() == ".toml") {
      found.push_back({entry.path().stem().string(), entry.path().string()});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const NamedFile& a, const NamedFile& b) { return a.name < b.name; });
  return found;
}

NamedFile find_station(const std::string& name) {
  if (fs::path(name).extension() == ".toml") {
    if (!is_regular_file(name)) {
      throw ConfigurationError(fmt::format("{}: no such station file", name));
    }
    return {fs::path(name).stem().string(), name};
  }
  std::vector<std::string> names;
  for (const NamedFile& station : all_stations()) {
    if (station.name == name) {
      return station;
    }
    names.push_back(station.name);
  }
  throw ConfigurationError(
      fmt::format("no station \"{}\"{} (a file of your own is given by its path, ending in .toml)",
                  name, keys::suggestion(name, names, "stations")));
}

std::vector<std::string> emulated_boards() {
  std::vector<std::string> names;
  for (const gs::boards::Board& board : gs::boards::kBoards) {
    if (gs::boards::is_emulated(board)) {
      names.emplace_back(board.name);
    }
  }
  return names;
}

std::vector<EmulatedOutletSpec> read_emulated(const Table& top) {
  std::vector<EmulatedOutletSpec> outlets;
  std::set<std::string> ids;
  for (const Table& table : top.tables("outlet")) {
    EmulatedOutletSpec outlet;
    outlet.id = table.text("id");
    if (outlet.id == kBenchUser) {
      table.refuse("id",
                   fmt::format("\"{}\" is what the bench is called on its broker", outlet.id));
    }
    outlet.board = table.text("board");
    outlet.link = table.text("link");
    outlet.crystal_ppm = table.number("crystal_ppm");
    if (outlet.link == "mqtt" && !gs::boards::find(outlet.board.c_str())->has_radio) {
      table.refuse("link",
                   fmt::format("link is \"mqtt\"; the board {} has no radio, only \"serial\"",
                               outlet.board));
    }
    if (!ids.insert(outlet.id).second) {
      table.refuse("id", fmt::format("there is an outlet \"{}\" already", outlet.id));
    }
    outlets.push_back(outlet);
  }
  if (outlets.empty()) {
    top.refuse_missing("outlet", "at least one [[outlet]] to emulate");
  }
  if (outlets.size() > kMostEmulated) {
    top.refuse("outlet", fmt::format("more than {} emulated outlets", kMostEmulated));
  }
  return outlets;
}

std::vector<std::string> texts(const std::vector<Word>& words) {
  std::vector<std::string> all;
  all.reserve(words.size());
  for (const Word& word : words) {
    all.push_back(word.text);
  }
  return all;
}

void read_serial(const Table& table, StationSpec& station) {
  station.serial_ports = texts(table.words("ports"));
  station.baud = static_cast<int>(table.whole("baud"));
}

bool is_broker_url(const std::string& url) {
  std::smatch parts;
  static const std::regex kForm("mqtts?://[^/:]+:([0-9]{1,5})");
  return std::regex_match(url, parts, kForm) && std::stoi(parts[1]) >= 1 &&
         std::stoi(parts[1]) <= 65535;
}

std::vector<std::string> outlet_ids(const Table& table) {
  std::vector<std::string> ids;
  for (const Word& word : table.words("outlets")) {
    if (std::count(ids.begin(), ids.end(), word.text) > 0) {
      table.refuse(word.at, fmt::format("outlet \"{}\" is named already", word.text));
    }
    ids.push_back(word.text);
  }
  return ids;
}

void read_mqtt(const Table& table, StationSpec& station) {
  station.broker.url = table.text("url");
  const bool tls = station.broker.url.rfind("mqtts://", 0) == 0;
  if (!is_broker_url(station.broker.url)) {
    table.refuse("url", fmt::format("url is \"{}\"; it must be mqtts://host:port, or "
                                    "mqtt://host:port where TLS is not wanted",
                                    station.broker.url));
  }
  const auto beside = [&](const std::optional<std::string>& path) {
    return path ? resolve(*path, station.path) : std::string();
  };
  station.broker.ca_file = beside(table.find_text("ca_file"));
  if (tls && station.broker.ca_file.empty()) {
    table.refuse_missing("ca_file", "the certificate that vouches for the broker: ca_file = …");
  }
  station.broker.user = table.find_text("user").value_or("");
  station.broker.password_file = beside(table.find_text("password_file"));
  station.broker.outlets = outlet_ids(table);
}

StationKind kind_of(const std::string& word) {
  return word == "emulated"   ? StationKind::kEmulated
         : word == "physical" ? StationKind::kPhysical
                              : StationKind::kSimulated;
}

StationSpec parse_station(const NamedFile& file) {
  const keys::Document document = keys::parse_toml(read_file(file.path), file.path);
  const Table top(document, station_keys());
  StationSpec station;
  station.name = file.name;
  station.path = file.path;
  station.title = top.text("title");
  const std::string kind = top.text("kind");
  station.kind = kind_of(kind);
  const auto only_for = [&](const char* key, StationKind where) {
    if (top.has(key) && station.kind != where) {
      top.refuse(top.at(key),
                 fmt::format("{} means nothing to a station of kind \"{}\"", key, kind));
    }
  };
  only_for("outlet", StationKind::kEmulated);
  only_for("image", StationKind::kEmulated);
  only_for("serial", StationKind::kPhysical);
  only_for("mqtt", StationKind::kPhysical);
  if (station.kind == StationKind::kEmulated) {
    station.emulated = read_emulated(top);
    const auto image = top.find_text("image");
    station.image = image ? resolve(*image, file.path) : "";
    if (image && !is_regular_file(station.image)) {
      top.refuse("image", fmt::format("image is \"{}\", and there is no such file", *image));
    }
  }
  if (station.kind == StationKind::kPhysical) {
    if (top.has("serial")) read_serial(top.table("serial"), station);
    if (top.has("mqtt")) read_mqtt(top.table("mqtt"), station);
    if (station.serial_ports.empty() && station.broker.url.empty()) {
      top.refuse_missing("serial", "where the outlets are: [serial] or [mqtt]");
    }
  }
  return station;
}

}  // namespace

const Key& station_keys() {
  static const Key keys = keys::table(
      "a station", "",
      {keys::text("title", "one line for lists").require(),
       keys::word("kind", {"simulated", "emulated", "physical"},
                  "outlets in the bench's process; processes that the bench starts and ends; "
                  "outlets that are there")
           .require("kind = \"simulated\", \"emulated\" or \"physical\""),
       keys::text("image", "emulated: the firmware image of the boards in qemu")
           .permits("path")
           .or_else("the one that was built"),
       keys::tables(
           "outlet",
           "1 … 64, emulated stations only. A profile with more outlets is cut to what is there, "
           "some of each group; one with more groups than there are outlets is refused.",
           {keys::id("id", kLongestId, "its name: each once, and not `bench`")
                .require("what the outlet is called: id = \"m4-1\""),
            keys::word("board", emulated_boards(),
                       "a Cortex-M4F in qemu, or the firmware as a process")
                .by_default("host"),
            keys::word("link", {"serial", "mqtt"},
                       "how it is reached; boards in qemu have no radio")
                .by_default("serial"),
            keys::number("crystal_ppm", "ppm", keys::between(-kMostPpm, kMostPpm),
                         "by how much its sample clock is fast")
                .by_default(0.0)}),
       keys::table("serial", "Physical stations only, which need this or the next.",
                   {keys::array("ports", keys::text("", ""),
                                "one outlet on each; one that does not answer is at fault")
                        .permits("array of device paths or `tcp://host:port`, at least one")
                        .require("the ports: ports = [\"/dev/ttyUSB0\"]"),
                    keys::whole("baud", "bit/s", 9600, 4000000, "of serial ports")
                        .by_default(StationSpec{}.baud)}),
       keys::table(
           "mqtt", "Physical stations only.",
           {keys::text("url", "the broker")
                .permits("`mqtts://host:port`, or `mqtt://host:port` without TLS")
                .require(),
            keys::text("ca_file", "the certificate that vouches for it")
                .permits("path")
                .or_else("required with `mqtts`"),
            keys::text("user", "the bench's name there"),
            keys::text("password_file", "holds its password in the first line").permits("path"),
            keys::array("outlets", keys::id("", kLongestId, ""),
                        "one that is named and not there is at fault")
                .permits("array of ids, each once")
                .or_else("all that are found")})});
  return keys;
}

StationSpec load_station(const std::string& name) {
  return parse_station(find_station(name));
}

std::vector<ProfileSummary> list_stations() {
  std::vector<ProfileSummary> summaries;
  for (const NamedFile& file : all_stations()) {
    try {
      summaries.push_back({file.name, parse_station(file).title});
    } catch (const ConfigurationError& error) {
      summaries.push_back({file.name, fmt::format("unreadable: {}", error.what())});
    }
  }
  return summaries;
}

}  // namespace gsbench::profile
