// Station files: where the outlets are and how they are reached. Who tests edits these, and never
// what is tested. profiles/README.md documents every key.
#pragma once

#include <link_framed/framed_link.hpp>
#include <link_mqtt/mqtt_link.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <keys/key.hpp>
#include <link/link.hpp>
#include <profile/load.hpp>
#include <profile/plan.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Outlets that are there: on serial ports and on a broker.
struct PhysicalOutlets {
  link::FramedOptions serial;      // without ports: none
  link::MqttOptions mqtt;          // without a URL: none
  std::string password_file = {};  // holds the broker's password in the first line; empty: mqtt's
};

// Throws keys::ConfigurationError where the password cannot be read.
std::unique_ptr<link::Link> make_link(PhysicalOutlets outlets);

// One that was read: of one of the kinds in station_file.cpp.
struct StationFile {
  std::string name;
  std::string title;
  std::string path;
  // How many outlets it has; none: as many as a plan asks for.
  std::optional<std::size_t> outlets = {};
  // Outlets that can be reached without a run; none: they are there only while one plays to them.
  std::optional<PhysicalOutlets> reachable = {};
  // Throws profile::ConfigurationError where nothing plays to its outlets, std::runtime_error where
  // it cannot be set up.
  std::function<std::unique_ptr<Station>(const profile::Plan&, const SimulatedOptions&)>
      make_station = {};
};

const keys::Key& station_keys();

// `name`: a shipped station ("emulated") or a path to a .toml file. Throws
// profile::ConfigurationError.
StationFile load_station(const std::string& name);

// In alphabetical order; one that cannot be read is listed with the reason for its title.
std::vector<profile::ProfileSummary> list_stations();

// A station with fewer outlets than the profile asks for plays to some of each group: the plan with
// just those. Throws profile::ConfigurationError where a group would be left without one.
profile::Plan fit_to_station(const StationFile& station, const profile::Plan& plan);

}  // namespace gsbench::station
