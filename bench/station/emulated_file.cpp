
#include "emulated_station.hpp"
#include "station_kind.hpp"

#include <set>

#include <fmt/format.h>

#include <boards/boards.hpp>
#include <profile/files.hpp>

namespace gsbench::station {
namespace {

constexpr double kMostPpm = 1000.0;
constexpr std::size_t kMostEmulated = 64;  // processes of one station
constexpr const char* kBenchUser = "bench";

std::vector<std::string> emulated_boards() {
  std::vector<std::string> names;
  for (const gs::boards::Board& board : gs::boards::kBoards) {
    if (gs::boards::is_emulated(board)) {
      names.emplace_back(board.name);
    }
  }
  return names;
}

std::vector<emulation::HardwareOutlet> read_outlets(const keys::Table& top) {
  std::vector<emulation::HardwareOutlet> outlets;
  std::set<std::string> ids;
  for (const keys::Table& table : top.tables("outlet")) {
    emulation::HardwareOutlet outlet;
    outlet.id = table.text("id");
    if (outlet.id == kBenchUser) {
      table.refuse("id",
                   fmt::format("\"{}\" is what the bench is called on its broker", outlet.id));
    }
    outlet.board = table.text("board");
    const bool by_radio = table.text("link") == "mqtt";
    outlet.connection = by_radio ? emulation::Connection::kMqtt : emulation::Connection::kSerial;
    outlet.crystal_ppm = table.number("crystal_ppm");
    if (by_radio && !gs::boards::find(outlet.board.c_str())->has_radio) {
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

std::unique_ptr<StationFile> read_emulated(const keys::Table& top, const std::string& path) {
  auto file = std::make_unique<EmulatedFile>();
  file->hardware = read_outlets(top);
  if (const auto image = top.find_text("image")) {
    file->image = profile::resolve(*image, path);
    if (!profile::is_regular_file(file->image)) {
      top.refuse("image", fmt::format("image is \"{}\", and there is no such file", *image));
    }
  }
  return file;
}

}  // namespace

std::unique_ptr<Station> EmulatedFile::make_station(const profile::Plan& plan,
                                                    const SimulatedOptions&) const {
  return std::make_unique<EmulatedStation>(name, hardware, image, plan);
}

StationKind emulated_kind() {
  return {
      "emulated",
      "processes that the bench starts and ends",
      {keys::text("image", "emulated: the firmware image of the boards in qemu")
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
                .by_default(0.0)})},
      read_emulated};
}

}  // namespace gsbench::station
