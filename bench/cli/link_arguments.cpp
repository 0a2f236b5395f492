#include "link_arguments.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <station/station_file.hpp>
#include <transport/transport.hpp>

namespace gsbench::cli {
namespace {

// A path may be relative on the command line.
std::string port_of(const std::string& given) {
  const bool is_path =
      given.find('/') != std::string::npos && given.find("://") == std::string::npos;
  std::string port = is_path ? std::filesystem::absolute(given).lexically_normal().string() : given;
  if (const drivers::Status form = transport::check_form(port); !form.ok()) {
    throw profile::ConfigurationError(form.error());
  }
  return transport::in_one_form(port);
}

// Of several names of one port, the first remains.
std::vector<std::string> each_once(const std::vector<std::string>& ports) {
  std::vector<std::string> different;
  std::set<std::string> known;
  for (const std::string& port : ports) {
    const std::vector<std::string> identities = station::lock_files(port);
    const bool is_known = std::any_of(identities.begin(), identities.end(),
                                      [&](const auto& one) { return known.count(one) > 0; });
    known.insert(identities.begin(), identities.end());
    if (!is_known) {
      different.push_back(port);
    }
  }
  return different;
}

station::PhysicalOutlets outlets_of(const LinkArguments& arguments) {
  if (!arguments.station.empty()) {
    const auto file = station::load_station(arguments.station);
    if (!file.reachable) {
      throw profile::ConfigurationError(file.path +
                                        ": no outlet of this station can be reached without a run");
    }
    return *file.reachable;
  }
  station::PhysicalOutlets outlets;
  for (const std::string& given : arguments.ports) {
    outlets.serial.ports.push_back(port_of(given));
  }
  if (arguments.ports.empty()) {
    outlets.serial.ports = transport::serial_ports();
  }
  if (outlets.serial.ports.empty()) {
    throw profile::ConfigurationError(
        "this machine has no serial port; name a station with --station");
  }
  return outlets;
}

// Locks the ports; keeps those that no other bench uses.
void lock_ports(ReachableOutlets& reached, const std::string& doing) {
  std::vector<std::string> free;
  for (const std::string& port : reached.ports) {
    try {
      reached.locks.push_back(
          std::make_unique<station::StationLock>(std::vector<std::string>{port}, doing));
      free.push_back(port);
    } catch (const station::StationBusy& busy) {
      if (reached.is_search) {
        print_error(std::string(busy.what()) + "; this port is left out");
        continue;
      }
      if (reached.ports.size() == 1 && reached.broker.empty()) {
        throw;
      }
      reached.in_use.push_back(
          {port, port, {}, std::string(busy.what()).substr(port.size() + std::strlen(": "))});
    }
  }
  reached.ports = std::move(free);
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

std::string ReachableOutlets::places() const {
  std::string text = fmt::format("{}", fmt::join(ports, ", "));
  if (!broker.empty()) {
    text += (text.empty() ? "the broker " : " and the broker ") + broker;
  }
  return text;
}

std::vector<link::Fault> ReachableOutlets::not_joined() const {
  std::vector<link::Fault> faults = link->missing();
  if (is_search) {
    const std::vector<link::Fault> closed = link->unreachable();
    faults.erase(std::remove_if(faults.begin(), faults.end(),
                                [&](const link::Fault& fault) {
                                  return std::any_of(
                                      closed.begin(), closed.end(),
                                      [&](const link::Fault& one) { return one.id == fault.id; });
                                }),
                 faults.end());
  }
  return faults;
}

ReachableOutlets reach_outlets(const LinkArguments& arguments, const std::string& command) {
  station::PhysicalOutlets there = outlets_of(arguments);
  ReachableOutlets reached;
  reached.is_search = arguments.station.empty() && arguments.ports.empty();
  reached.broker = there.mqtt.url;
  reached.ids = there.mqtt.outlets;
  reached.ports = each_once(there.serial.ports);
  lock_ports(reached, "command " + command);
  there.serial.ports = reached.ports;
  there.mqtt.keeps_session = false;
  reached.link = station::make_link(there);
  return reached;
}

}  // namespace gsbench::cli
