// Station files: where the outlets are and how they are reached. Who tests edits this, and never
// what is tested. profiles/README.md documents every key.
#pragma once

#include <string>
#include <vector>

#include <keys/key.hpp>
#include <profile/load.hpp>

namespace gsbench::profile {

enum class StationKind {
  kSimulated,  // in the bench's process
  kEmulated,   // processes that the bench starts
  kPhysical,   // on ports and brokers that are there
};

struct EmulatedOutletSpec {
  std::string id;
  std::string board;         // of boards/boards.hpp
  std::string link;          // "serial" or "mqtt"
  double crystal_ppm = 0.0;  // by how much its crystal is fast; −1000 … 1000
};

struct BrokerSpec {
  std::string url;  // mqtts://host:port, mqtt://host:port without TLS; empty: none
  std::string ca_file;
  std::string user;
  std::string password_file;         // holds it in the first line
  std::vector<std::string> outlets;  // ids; empty: all that are found
};

struct StationSpec {
  std::string name;
  std::string title;
  std::string path;
  StationKind kind = StationKind::kSimulated;
  std::vector<EmulatedOutletSpec> emulated;
  std::string image;  // of the boards in qemu; empty: those that were built
  std::vector<std::string> serial_ports;
  int baud = 921600;
  BrokerSpec broker;
};

const keys::Key& station_keys();

// `name`: a shipped station ("emulated") or a path to a .toml file. Throws ConfigurationError.
StationSpec load_station(const std::string& name);

// In alphabetical order; one that cannot be read is listed with the reason for its title.
std::vector<ProfileSummary> list_stations();

}  // namespace gsbench::profile
