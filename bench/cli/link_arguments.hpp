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

// A link to outlets, and which of them are expected.
struct ReachableOutlets {
  std::vector<std::unique_ptr<station::StationLock>> locks;  // of the serial and TCP ports
  std::unique_ptr<link::Link> link;                          // not open
  std::vector<std::string> ports;  // that it opens, each once: a port may have several names
  std::vector<std::string> ids;    // that the station names behind its broker
  std::string broker;              // its URL; empty: none
  // All serial ports are searched: one without an outlet is no fault.
  bool is_search = false;
  // Ports that were given, but that another bench uses: left out, each with its fault.
  std::vector<link::OutletPresence> in_use;

  // "/dev/ttyUSB0 and the broker mqtts://lab:8883"
  std::string places() const;
  // Of the open link: outlets that have not joined, with the reason, by port or by id. Of a search,
  // without the ports that cannot be opened.
  std::vector<link::Fault> not_joined() const;
};

// The outlets of the station, or on the given ports, or on all serial ports. Locks the ports: to
// read one that a run uses would spoil the run. Behind a broker any number of benches may listen;
// the broker keeps nothing for them after their end. Connects to nothing, and does not look whether
// a port exists. `command`: for the message to others.
//
// Throws profile::ConfigurationError if there is no port, or a text cannot be a port, and
// station::StationBusy if another bench uses the only port that was given (of all serial ports,
// those in use are left out, with a message).
ReachableOutlets reach_outlets(const LinkArguments& arguments, const std::string& command);

}  // namespace gsbench::cli
