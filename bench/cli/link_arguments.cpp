#include "link_arguments.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include <link/wait_for_outlets.hpp>
#include <station/station_file.hpp>
#include <transport/transport.hpp>

namespace gsbench::cli {
namespace {

constexpr auto kPatience = std::chrono::seconds(3);      // for the named outlets
constexpr auto kForSearching = std::chrono::seconds(1);  // for all outlets on a broker

// A port that was given must exist; other ports of the machine that cannot be opened are skipped.
void require_ports(const std::vector<std::string>& named) {
  for (const std::string& port : named) {
    const drivers::Status there = transport::check_port(port);
    if (!there.ok()) {
      throw profile::ConfigurationError(there.error());
    }
  }
}

station::PhysicalOutlets outlets_of(const LinkArguments& arguments) {
  if (!arguments.station.empty()) {
    const auto file = station::load_station(arguments.station);
    if (!file.reachable) {
      throw profile::ConfigurationError(file.path +
                                        ": no outlet of this station can be reached without a run");
    }
    require_ports(file.reachable->serial.ports);
    return *file.reachable;
  }
  require_ports(arguments.ports);
  station::PhysicalOutlets outlets;
  outlets.serial.ports = arguments.ports.empty() ? transport::serial_ports() : arguments.ports;
  if (outlets.serial.ports.empty()) {
    throw profile::ConfigurationError(
        "this machine has no serial port; name a station with --station");
  }
  return outlets;
}

// Keeps the ports that no other bench uses, locked.
std::vector<std::unique_ptr<station::StationLock>> lock_free_ones(std::vector<std::string>& ports,
                                                                  const std::string& doing) {
  std::vector<std::unique_ptr<station::StationLock>> locks;
  std::vector<std::string> free;
  for (const std::string& port : ports) {
    try {
      locks.push_back(
          std::make_unique<station::StationLock>(std::vector<std::string>{port}, doing));
      free.push_back(port);
    } catch (const station::StationBusy& busy) {
      print_error(std::string(busy.what()) + "; this port is left out");
    }
  }
  ports = free;
  return locks;
}

}  // namespace

void add_link_options(CLI::App& command, LinkArguments& arguments) {
  CLI::Option* station = command
                             .add_option("--station", arguments.station,
                                         "Name of a station, or a .toml file; in place of --port")
                             ->type_name("STATION");
  command
      .add_option(
          "--port", arguments.ports,
          "Serial port, or tcp://host:port; may be given several times (default: all serial "
          "ports of this machine)")
      ->type_name("PORT")
      ->excludes(station);
}

FoundOutlets find_outlets(const LinkArguments& arguments, const std::string& command) {
  station::PhysicalOutlets there = outlets_of(arguments);
  const bool looking = arguments.station.empty() && arguments.ports.empty();
  FoundOutlets found;
  if (looking) {
    found.locks = lock_free_ones(there.serial.ports, "command " + command);
  } else {
    found.locks.push_back(
        std::make_unique<station::StationLock>(there.serial.ports, "command " + command));
  }
  std::vector<std::string> named = there.serial.ports;
  named.insert(named.end(), there.mqtt.outlets.begin(), there.mqtt.outlets.end());
  const bool any_on_broker = !there.mqtt.url.empty() && there.mqtt.outlets.empty();
  found.link = station::make_link(there);
  auto outlets = link::wait_for_outlets(*found.link, named, kPatience,
                                        any_on_broker ? kForSearching : std::chrono::seconds(0));
  if (!outlets.ok()) {
    throw std::runtime_error(outlets.error());
  }
  found.outlets = outlets.take();
  if (looking) {
    found.outlets.erase(std::remove_if(found.outlets.begin(), found.outlets.end(),
                                       [](const auto& outlet) { return outlet.where.empty(); }),
                        found.outlets.end());
  }
  for (link::OutletPresence& outlet : found.outlets) {
    if (outlet.where.empty()) {
      const auto& ports = there.serial.ports;
      const bool is_port = std::find(ports.begin(), ports.end(), outlet.id) != ports.end();
      outlet.where = is_port ? outlet.id : there.mqtt.url;  // where it was expected
    }
  }
  return found;
}

}  // namespace gsbench::cli
