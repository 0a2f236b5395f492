#include "commands.hpp"
#include "link_arguments.hpp"
#include "message_text.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <link/version_text.hpp>
#include <link/wait_for_outlets.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

struct DevicesArguments {
  LinkArguments link;
  bool json = false;
};

constexpr auto kPatience = std::chrono::seconds(3);  // for the named outlets
// For all outlets on a broker, and for two that end each other's connection.
constexpr auto kForSearching = std::chrono::seconds(1);

struct Device {
  link::OutletPresence outlet;
  bool answers = false;  // with or without a fault
};

// With the ports that were given, and that another bench uses.
std::vector<Device> devices_of(ReachableOutlets& reached) {
  std::vector<std::string> named = reached.ports;
  named.insert(named.end(), reached.ids.begin(), reached.ids.end());
  if (const drivers::Status opened = reached.link->open(); !opened.ok()) {
    throw std::runtime_error(opened.error());
  }
  const std::vector<link::Fault> closed = reached.link->unreachable();
  for (const link::Fault& port : closed) {  // they are not waited for
    named.erase(std::remove(named.begin(), named.end(), port.id), named.end());
  }
  auto found =
      link::wait_on_open_link(*reached.link, named, kPatience,
                              reached.broker.empty() ? std::chrono::seconds(0) : kForSearching);
  if (!found.ok()) {
    throw std::runtime_error(found.error());
  }
  const std::vector<link::Fault> not_joined = reached.not_joined();
  std::vector<Device> devices;
  for (link::OutletPresence& outlet : found.take()) {
    const bool answers = !outlet.where.empty();
    if (answers) {
      // Without the place that one of two with the same id has.
      if (outlet.id == std::string(outlet.hello.id) + " on " + outlet.where) {
        outlet.id = outlet.hello.id;
      }
    } else {
      const bool is_port =
          std::find(reached.ports.begin(), reached.ports.end(), outlet.id) != reached.ports.end();
      outlet.where = is_port ? outlet.id : reached.broker;  // where it was expected
    }
    const bool is_heard = std::any_of(not_joined.begin(), not_joined.end(),
                                      [&](const auto& fault) { return fault.id == outlet.id; });
    if (answers || is_heard || !reached.is_search) {
      devices.push_back({std::move(outlet), answers});
    }
  }
  for (const link::Fault& port : closed) {
    const bool has_opened = std::any_of(devices.begin(), devices.end(), [&](const Device& device) {
      return device.outlet.where == port.id;
    });
    if (!reached.is_search && !has_opened) {
      devices.push_back({{port.id, port.id, {}, port.what}, false});
    }
  }
  for (const link::OutletPresence& port : reached.in_use) {
    devices.push_back({port, false});
  }
  return devices;
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

void print(const std::vector<Device>& present) {
  std::vector<link::OutletPresence> answering;
  for (const Device& device : present) {
    if (device.outlet.fault.empty()) {
      answering.push_back(device.outlet);
    }
  }
  if (!answering.empty()) {
    print_table(answering);
  }
  for (const auto& [outlet, answers] : present) {
    if (!outlet.fault.empty()) {
      const std::string where = outlet.where == outlet.id ? "" : " at " + outlet.where;
      print_line(fmt::format("! {}{}: {}", outlet.id, where, outlet.fault), 4);
    }
  }
}

int devices(const DevicesArguments& arguments) {
  ReachableOutlets reached = reach_outlets(arguments.link, "devices");
  const std::vector<Device> present = devices_of(reached);
  if (arguments.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Device& device : present) {
      all.push_back(as_json(device.outlet, device.answers));
    }
    print_json(all);
  } else if (present.empty()) {
    print_error("no outlet answers");
  } else {
    print(present);
  }
  const bool all_answer = std::all_of(present.begin(), present.end(), [](const Device& device) {
    return device.outlet.fault.empty();
  });
  return all_answer ? kPassed : kErrored;
}

}  // namespace

void add_devices(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "devices", "List the outlets on serial or TCP ports, or behind an MQTT broker", devices);
  add_link_options(command, arguments.link);
  add_json_flag(command, arguments.json);
  command.footer(
      "Exit code 4 if an outlet does not answer, sends a hello that cannot be read, has the same "
      "id "
      "as\n"
      "another outlet, or uses another version of the protocol, or if a port that was given cannot "
      "be\n"
      "opened, or another bench uses it. A search that finds none, of all serial ports or on a "
      "broker\n"
      "without named outlets, is no fault: exit code 0.\n"
      "--json: a list with one object for each outlet, each with the \"format_version\", 1. Of an\n"
      "outlet that does not answer, only its place (or id) and its fault are given.\n"
      "\n"
      "Examples:\n"
      "  gsbench devices                          on every serial port of this machine\n"
      "  gsbench devices --port /dev/ttyUSB0\n"
      "  gsbench devices --station my-station.toml");
}

}  // namespace gsbench::cli
