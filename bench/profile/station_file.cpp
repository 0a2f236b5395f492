#include "files.hpp"
#include "nearest.hpp"
#include "table.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include <fmt/format.h>

#include <profile/station_spec.hpp>

namespace gsbench::profile {
namespace {

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
                  name, suggestion(name, names, "stations")));
}

std::vector<EmulatedOutletSpec> read_emulated(const Table& top) {
  std::vector<EmulatedOutletSpec> outlets;
  std::set<std::string> ids;
  for (const Value* value : top.tables("outlet")) {
    const Table table(top.document(), *value, "[[outlet]]", {"id", "board", "link", "crystal_ppm"});
    EmulatedOutletSpec outlet;
    const auto id = table.identifier("id", kLongestId);
    if (!id) {
      table.refuse_missing("id", "what the outlet is called: id = \"m4-1\"");
    }
    outlet.id = *id;
    if (outlet.id == kBenchUser) {
      table.refuse("id", fmt::format("\"{}\" is what the bench is called on its broker", *id));
    }
    outlet.board = table.choice("board", {"mps2-an386", "host"}).value_or("host");
    outlet.link = table.choice("link", {"serial", "mqtt"}).value_or("serial");
    outlet.crystal_ppm = table.number("crystal_ppm", between(-kMostPpm, kMostPpm)).value_or(0.0);
    if (outlet.board == "mps2-an386" && outlet.link != "serial") {
      table.refuse("link", "link is \"mqtt\"; the board mps2-an386 has no radio, only \"serial\"");
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

void read_serial(const Table& top, StationSpec& station) {
  const Value* section = top.table("serial");
  if (section == nullptr) {
    return;
  }
  const Table table(top.document(), *section, "[serial]", {"ports", "baud"});
  station.serial_ports = texts(table.words("ports"));
  if (station.serial_ports.empty()) {
    table.refuse_missing("ports", "the ports: ports = [\"/dev/ttyUSB0\"]");
  }
  station.baud = static_cast<int>(table.integer("baud", 9600, 4000000).value_or(station.baud));
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
    if (!is_identifier(word.text, kLongestId)) {
      table.refuse(word.at, fmt::format("\"{}\" is no outlet's id: letters, digits, '-', '_' and "
                                        "'.', at most {} of them",
                                        word.text, kLongestId));
    }
    if (std::count(ids.begin(), ids.end(), word.text) > 0) {
      table.refuse(word.at, fmt::format("outlet \"{}\" is named already", word.text));
    }
    ids.push_back(word.text);
  }
  return ids;
}

void read_mqtt(const Table& top, StationSpec& station) {
  const Value* section = top.table("mqtt");
  if (section == nullptr) {
    return;
  }
  const Table table(top.document(), *section, "[mqtt]",
                    {"url", "ca_file", "user", "password_file", "outlets"});
  station.broker.url = table.required_text("url");
  const bool tls = station.broker.url.rfind("mqtts://", 0) == 0;
  if (!is_broker_url(station.broker.url)) {
    table.refuse("url", fmt::format("url is \"{}\"; it must be mqtts://host:port, or "
                                    "mqtt://host:port where TLS is not wanted",
                                    station.broker.url));
  }
  const auto beside = [&](const std::optional<std::string>& path) {
    return path ? resolve(*path, station.path) : std::string();
  };
  station.broker.ca_file = beside(table.text("ca_file"));
  if (tls && station.broker.ca_file.empty()) {
    table.refuse_missing("ca_file", "the certificate that vouches for the broker: ca_file = …");
  }
  station.broker.user = table.text("user").value_or("");
  station.broker.password_file = beside(table.text("password_file"));
  station.broker.outlets = outlet_ids(table);
}

StationKind kind_of(const std::string& word) {
  return word == "emulated"   ? StationKind::kEmulated
         : word == "physical" ? StationKind::kPhysical
                              : StationKind::kSimulated;
}

Table open_top(const Document& document) {
  return {
      document, document.root, "a station", {"title", "kind", "outlet", "image", "serial", "mqtt"}};
}

StationSpec parse_station(const NamedFile& file) {
  const Document document = parse_toml(read_file(file.path), file.path);
  const Table top = open_top(document);
  StationSpec station;
  station.name = file.name;
  station.path = file.path;
  station.title = top.required_text("title");
  const auto kind = top.choice("kind", {"simulated", "emulated", "physical"});
  if (!kind) {
    top.refuse_missing("kind", "kind = \"simulated\", \"emulated\" or \"physical\"");
  }
  station.kind = kind_of(*kind);
  const auto only_for = [&](const char* key, StationKind where) {
    if (top.has(key) && station.kind != where) {
      top.refuse(top.at(key),
                 fmt::format("{} means nothing to a station of kind \"{}\"", key, *kind));
    }
  };
  only_for("outlet", StationKind::kEmulated);
  only_for("image", StationKind::kEmulated);
  only_for("serial", StationKind::kPhysical);
  only_for("mqtt", StationKind::kPhysical);
  if (station.kind == StationKind::kEmulated) {
    station.emulated = read_emulated(top);
    const auto image = top.text("image");
    station.image = image ? resolve(*image, file.path) : "";
    if (image && !is_regular_file(station.image)) {
      top.refuse("image", fmt::format("image is \"{}\", and there is no such file", *image));
    }
  }
  if (station.kind == StationKind::kPhysical) {
    read_serial(top, station);
    read_mqtt(top, station);
    if (station.serial_ports.empty() && station.broker.url.empty()) {
      top.refuse_missing("serial", "where the outlets are: [serial] or [mqtt]");
    }
  }
  return station;
}

}  // namespace

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
