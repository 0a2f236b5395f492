// Station files describe where the outlets are and how they are reached. They differ between test
// benches; profiles do not. profiles/stations.md documents every key.
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

// Physical outlets on serial ports and on an MQTT broker.
struct PhysicalOutlets {
  link::FramedOptions serial;      // no ports: no outlets on serial ports
  link::MqttOptions mqtt;          // no URL: no outlets on a broker
  std::string password_file = {};  // its first line replaces mqtt.password; empty: no file
  // Where a station file names these files, for messages: "lab.toml:7:11".
  std::string ca_file_at = {};
  std::string password_file_at = {};
};

// Connects to nothing. Throws keys::ConfigurationError, with the place in the station file, if no
// CA certificate or no password can be read from its file.
std::unique_ptr<link::Link> make_link(PhysicalOutlets outlets);

// The content of a station file.
struct StationFile {
  std::string name;
  std::string title;
  std::string path;
  std::string text;  // of the file
  // Number of outlets; nullopt: as many as the plan has.
  std::optional<std::size_t> outlets = {};
  // Outlets that can be reached without a run; nullopt: they exist only during a run, or none has a
  // link.
  std::optional<PhysicalOutlets> reachable = {};
  // Throws profile::ConfigurationError if the station has no source, std::runtime_error if its
  // set-up fails.
  std::function<std::unique_ptr<Station>(const profile::Plan&, const SimulatedOptions&)>
      make_station = {};
  // The source of a physical station, not connected, and its port. Without them there is nothing to
  // make safe once the bench has ended. Its make_safe() makes one attempt. Throws
  // std::runtime_error.
  std::function<std::shared_ptr<source::Source>()> make_source = {};
  std::string source_port = {};
};

// Keys of a station file of this kind, one of station_kind_names().
const keys::Key& station_keys(const std::string& kind);
std::vector<std::string> station_kind_names();

// `name`: a shipped station ("emulated") or one in the user's folder, or the path of a .toml file.
// Throws profile::ConfigurationError.
StationFile load_station(const std::string& name);

// In alphabetical order. If a file cannot be read, its title is the reason why.
std::vector<profile::ProfileSummary> list_stations();

// Reduces the outlets of a plan to the number that the station has. At least one outlet of each
// group remains. Throws profile::ConfigurationError if the plan has more groups than the station
// has outlets.
profile::Plan fit_to_station(const StationFile& station, const profile::Plan& plan);

}  // namespace gsbench::station
