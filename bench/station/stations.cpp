#include "emulated_station.hpp"
#include <link_framed/framed_link.hpp>
#include <link_mqtt/mqtt_link.hpp>

#include <algorithm>
#include <fstream>

#include <link/combined_link.hpp>
#include <station/stations.hpp>

namespace gsbench::station {
namespace {

std::string first_line(const std::string& path) {
  std::string line;
  if (!path.empty() && !std::getline(std::ifstream(path), line)) {
    throw profile::ConfigurationError(path + ": no password can be read");
  }
  return line;
}

}  // namespace

std::unique_ptr<Station> make_station(const profile::StationSpec& spec, const profile::Plan& plan,
                                      const SimulatedOptions& simulated) {
  switch (spec.kind) {
    case profile::StationKind::kSimulated:
      return simulated_station(plan, simulated);
    case profile::StationKind::kEmulated:
      return std::make_unique<EmulatedStation>(spec, plan);
    case profile::StationKind::kPhysical:
      break;
  }
  throw profile::ConfigurationError(
      spec.path +
      ": this station has outlets and no source to play to them; `gsbench devices` and `gsbench "
      "monitor` work on it");
}

std::unique_ptr<link::Link> make_link(const profile::StationSpec& spec, bool looking) {
  std::vector<std::unique_ptr<link::Link>> links;
  if (!spec.serial_ports.empty()) {
    link::FramedOptions options;
    options.ports = spec.serial_ports;
    options.baud = spec.baud;
    options.skip_unusable = looking;
    links.push_back(std::make_unique<link::FramedLink>(options));
  }
  if (!spec.broker.url.empty()) {
    link::MqttOptions options;
    options.url = spec.broker.url;
    options.ca_file = spec.broker.ca_file;
    options.user = spec.broker.user;
    options.password = first_line(spec.broker.password_file);
    options.outlets = spec.broker.outlets;
    links.push_back(std::make_unique<link::MqttLink>(options));
  }
  return std::make_unique<link::CombinedLink>(std::move(links));
}

profile::Plan fit_to_station(const profile::StationSpec& spec, const profile::Plan& plan) {
  const std::size_t there = spec.emulated.size();
  if (spec.kind != profile::StationKind::kEmulated || there >= plan.outlets.size()) {
    return plan;
  }
  const std::vector<std::string> groups = profile::groups_of(plan.outlets);
  if (groups.size() > there) {
    throw profile::ConfigurationError(plan.path + ": has " + std::to_string(groups.size()) +
                                      " groups of outlets, and the station " + spec.name +
                                      " only " + std::to_string(there) + " outlets");
  }
  // One of each group in turn.
  std::vector<bool> taken(plan.outlets.size(), false);
  for (std::size_t chosen = 0; chosen < there;) {
    for (const std::string& group : groups) {
      for (std::size_t i = 0; i < plan.outlets.size() && chosen < there; ++i) {
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
