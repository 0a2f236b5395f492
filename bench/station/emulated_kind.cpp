#include "emulated_station.hpp"
#include "station_kind.hpp"

#include <set>

#include <fmt/format.h>

#include <boards/boards.hpp>
#include <profile/files.hpp>

namespace gsbench::station {
namespace {

constexpr double kMost_ppm = 1000.0;
constexpr double kLeastPickup_hz = 25.0;
constexpr double kMostPickup_hz = 90.0;
constexpr double kLongestDelay_s = 60.0;
constexpr std::size_t kMostEmulated = 64;  // one process each
constexpr const char* kBenchUser = "bench";

constexpr const char* kFrequencyRelay = "frequency-relay";

std::vector<std::string> emulated_devices() {
  std::vector<std::string> names = {kFrequencyRelay};
  for (const gs::boards::Board& board : gs::boards::kBoards) {
    if (gs::boards::is_emulated(board)) {
      names.emplace_back(board.name);
    }
  }
  return names;
}

// A device without firmware and without a link.
void read_frequency_relay(const keys::Table& table, emulation::HardwareOutlet& outlet) {
  if (table.has("link") && table.text("link") != "none") {
    table.refuse("link", fmt::format("link is \"{}\", but a {} has only a contact; it must be "
                                     "\"none\"",
                                     table.text("link"), kFrequencyRelay));
  }
  outlet.connection = emulation::Connection::kNone;
  outlet.frequency_relay = {table.number("pickup_hz"), table.number("delay_s")};
}

void read_board(const keys::Table& table, emulation::HardwareOutlet& outlet) {
  for (const char* key : {"pickup_hz", "delay_s"}) {
    if (table.has(key)) {
      table.refuse(key, fmt::format("{} is a key of the board \"{}\" only", key, kFrequencyRelay));
    }
  }
  const std::string link = table.text("link");
  if (link == "none") {
    table.refuse("link", fmt::format("link is \"none\", but the board {} reports over its link; it "
                                     "must be \"serial\" or \"mqtt\"",
                                     outlet.board));
  }
  outlet.connection =
      link == "mqtt" ? emulation::Connection::kMqtt : emulation::Connection::kSerial;
  if (link == "mqtt" && !gs::boards::find(outlet.board.c_str())->has_radio) {
    table.refuse(
        "link",
        fmt::format("link is \"mqtt\", but the board {} has no radio; it must be \"serial\"",
                    outlet.board));
  }
}

std::vector<emulation::HardwareOutlet> read_outlets(const keys::Table& top) {
  std::vector<emulation::HardwareOutlet> outlets;
  std::set<std::string> ids;
  for (const keys::Table& table : top.tables("outlet")) {
    emulation::HardwareOutlet outlet;
    outlet.id = table.text("id");
    if (outlet.id == kBenchUser) {
      table.refuse(
          "id", fmt::format("\"{}\" is the user name of the bench on its broker; choose another id",
                            outlet.id));
    }
    outlet.board = table.text("board");
    outlet.crystal_ppm = table.number("crystal_ppm");
    if (outlet.board == kFrequencyRelay) {
      read_frequency_relay(table, outlet);
    } else {
      read_board(table, outlet);
    }
    if (!ids.insert(outlet.id).second) {
      table.refuse("id", fmt::format("the id \"{}\" is used twice; it must be unique", outlet.id));
    }
    outlets.push_back(outlet);
  }
  if (outlets.empty()) {
    top.refuse_missing("outlet", "at least one [[outlet]]");
  }
  if (outlets.size() > kMostEmulated) {
    top.refuse("outlet", fmt::format("{} emulated outlets; at most {} are possible", outlets.size(),
                                     kMostEmulated));
  }
  return outlets;
}

std::vector<keys::Key> emulated_keys() {
  std::vector<keys::Key> all = {
      keys::text("image", "firmware image of the boards in qemu")
          .permits("path")
          .or_else("the firmware that comes with gsbench"),
      keys::tables(
          "outlet",
          "1 … 64 outlets. If a profile has more outlets than the "
          "station, each group is reduced; at least one outlet of it remains. A profile with more "
          "groups than the station has outlets is refused.",
          {keys::id("id", kLongestId, "name of the outlet; unique, and not `bench`")
               .require("the name of the outlet, e.g. id = \"m4-1\""),
           keys::choice("board", emulated_devices(),
                        "`mps2-an386`: a Cortex-M4F in qemu; `host`: the firmware as a process; "
                        "`frequency-relay`: a contact-only device without this firmware, which "
                        "opens its contact at low frequency")
               .by_default("host"),
           keys::choice("link", {"serial", "mqtt", "none"},
                        "connection to the bench; boards in qemu support `serial` only, a "
                        "`frequency-relay` only `none`")
               .by_default("serial"),
           keys::number("pickup_hz", "Hz", keys::between(kLeastPickup_hz, kMostPickup_hz),
                        "of a `frequency-relay`: its contact opens below this frequency")
               .by_default(emulation::FrequencyRelayOptions().pickup_hz),
           keys::number("delay_s", "s", keys::between(0.0, kLongestDelay_s),
                        "of a `frequency-relay`: how long the frequency must be low")
               .by_default(emulation::FrequencyRelayOptions().delay_s),
           keys::number("crystal_ppm", "ppm", keys::between(-kMost_ppm, kMost_ppm),
                        "frequency error of the sample clock; positive: fast")
               .by_default(0.0)})};
  for (const keys::Key& key : instrument_station_keys()) {
    all.insert(all.end() - 1, key);
  }
  return all;
}

}  // namespace

emulation::HardwareOptions read_emulated(const keys::Table& top, const std::string& file_path) {
  emulation::HardwareOptions options;
  options.outlets = read_outlets(top);
  if (const auto image = top.find_text("image")) {
    options.image = profile::resolve(*image, file_path);
    if (!profile::is_regular_file(options.image)) {
      top.refuse("image", fmt::format("image is \"{}\", which is not an existing file", *image));
    }
  }
  return options;
}

StationKind emulated_kind() {
  return {"emulated", "firmware processes that the bench starts and stops", emulated_keys(),
          [](const keys::Table& top, StationFile& file) {
            const emulation::HardwareOptions options = read_emulated(top, file.path);
            file.outlets = options.outlets.size();
            const auto instrument = read_instrument_options(top, file.path, options.outlets);
            file.make_station = [name = file.name, options, instrument](const profile::Plan& plan,
                                                                        const SimulatedOptions&) {
              return std::make_unique<EmulatedStation>(name, options, plan, instrument);
            };
          }};
}

}  // namespace gsbench::station
