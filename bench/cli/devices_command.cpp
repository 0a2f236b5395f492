#include "commands.hpp"
#include "link_arguments.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <link/version_text.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

struct DevicesArguments {
  LinkArguments link;
  bool json = false;
};

nlohmann::ordered_json as_json(const link::OutletPresence& outlet) {
  const gs::wire::Hello& hello = outlet.hello;
  return {{"id", outlet.id},
          {"where", outlet.where},
          {"fault", outlet.fault},
          {"board", hello.board},
          {"instance", hello.instance},
          {"protocol", hello.protocol_version},
          {"firmware", link::version_text(hello.firmware_version)},
          {"build", fmt::format("{:08x}", hello.build)},
          {"sample_rate_hz", hello.sample_rate_hz},
          {"nominal_hz", hello.nominal_hz},
          {"settings_version", hello.settings_version},
          {"settings_digest", fmt::format("{:08x}", hello.settings_digest)},
          {"keeps_settings", (hello.capabilities & gs::wire::kKeepsSettings) != 0},
          {"has_watchdog", (hello.capabilities & gs::wire::kHasWatchdog) != 0}};
}

std::vector<std::string> cells_of(const link::OutletPresence& outlet) {
  const gs::wire::Hello& hello = outlet.hello;
  const bool none = hello.settings_version == 0;
  return {hello.board,
          link::version_text(hello.firmware_version),
          fmt::format("{:08x}", hello.build),
          std::to_string(hello.sample_rate_hz),
          std::to_string(hello.nominal_hz),
          none ? "none" : std::to_string(hello.settings_version),
          none ? "–" : fmt::format("{:08x}", hello.settings_digest)};
}

// Those that answer. A place (a path or URL) for which a row has no room goes to the next line; a
// long id has a line of its own.
void print_table(const std::vector<link::OutletPresence>& answering) {
  constexpr std::size_t kIdColumns = 20;
  std::vector<std::vector<std::string>> rows = {
      {"", "", "", "", "samples", "mains,", "settings", "settings"},
      {"outlet", "board", "firmware", "build", "per s", "Hz", "version", "digest"}};
  for (const link::OutletPresence& outlet : answering) {
    rows.push_back(cells_of(outlet));
    rows.back().insert(rows.back().begin(), outlet.id.size() <= kIdColumns ? outlet.id : "");
  }
  const std::vector<std::string> lines = render::aligned(rows, "llllrrrl");
  std::puts(lines[0].c_str());
  std::puts((lines[1] + "    where").c_str());
  for (std::size_t i = 0; i < answering.size(); ++i) {
    if (answering[i].id.size() > kIdColumns) {
      std::puts(answering[i].id.c_str());
    }
    print_wrapped(lines[i + 2] + "  " + answering[i].where, 4);
  }
}

void print(const std::vector<link::OutletPresence>& present) {
  std::vector<link::OutletPresence> answering;
  std::copy_if(present.begin(), present.end(), std::back_inserter(answering),
               [](const auto& outlet) { return outlet.fault.empty(); });
  if (!answering.empty()) {
    print_table(answering);
  }
  for (const link::OutletPresence& outlet : present) {
    if (!outlet.fault.empty()) {
      const std::string where = outlet.where == outlet.id ? "" : " at " + outlet.where;
      print_wrapped(fmt::format("! {}{}: {}", outlet.id, where, outlet.fault), 4);
    }
  }
}

int devices(const DevicesArguments& arguments) {
  const std::vector<link::OutletPresence> present = find_outlets(arguments.link, "devices").outlets;
  if (arguments.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const link::OutletPresence& outlet : present) {
      all.push_back(as_json(outlet));
    }
    print_json(all);
  } else if (present.empty()) {
    print_error("no outlet answers");
  } else {
    print(present);
  }
  const bool all_answer = std::all_of(present.begin(), present.end(),
                                      [](const auto& outlet) { return outlet.fault.empty(); });
  return all_answer ? kPassed : kErrored;
}

}  // namespace

void add_devices(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "devices", "List the outlets on serial or TCP ports, or behind an MQTT broker", devices);
  add_link_options(command, arguments.link);
  add_json_flag(command, arguments.json);
  command.footer(
      "Exit code 4 if an outlet does not answer, has the same id as another outlet, or uses "
      "another\n"
      "version of the protocol, or if another bench uses a port that was given.\n"
      "\n"
      "Examples:\n"
      "  gsbench devices                          on every serial port of this machine\n"
      "  gsbench devices --port /dev/ttyUSB0\n"
      "  gsbench devices --station my-station.toml");
}

}  // namespace gsbench::cli
