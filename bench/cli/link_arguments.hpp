// --station and --port of the commands that only communicate with outlets.
#pragma once

#include "commands.hpp"

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <station/station_lock.hpp>

namespace gsbench::cli {

struct LinkArguments {
  std::string station;
  std::vector<std::string> ports;
};

void add_link_options(CLI::App& command, LinkArguments& arguments);

struct FoundOutlets {
  std::vector<std::unique_ptr<station::StationLock>> locks;  // of the serial and TCP ports
  std::unique_ptr<link::Link> link;                          // open
  std::vector<link::OutletPresence> outlets;
};

// Looks for the outlets of the station, or on the given ports, or on all serial ports; in the last
// case ports without an outlet are left out. Locks the ports: to read one that a run uses would
// spoil the run. Behind a broker any number of benches may listen. `command`: for the message to
// others. Blocks for up to 3 s if an outlet does not answer.
//
// Throws profile::ConfigurationError if there is no port or a given port does not exist,
// station::StationBusy if another bench uses a given port (of all serial ports, those in use are
// left out, with a message), and std::runtime_error with the error of the link.
FoundOutlets find_outlets(const LinkArguments& arguments, const std::string& command);

}  // namespace gsbench::cli
