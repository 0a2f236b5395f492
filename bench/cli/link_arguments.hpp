// --station and --port of the commands that only communicate with outlets.
#pragma once

#include "commands.hpp"

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::cli {

struct LinkArguments {
  std::string station;
  std::vector<std::string> ports;
};

void add_link_options(CLI::App& command, LinkArguments& arguments);

struct FoundOutlets {
  std::unique_ptr<link::Link> link;  // open
  std::vector<link::OutletPresence> outlets;
};

// Looks for the outlets of the station, or on the given ports, or on all serial ports; in the last
// case ports without an outlet are left out. Blocks for up to 3 s if an outlet does not answer.
// Throws profile::ConfigurationError if there is no port or a given port does not exist, and
// std::runtime_error with the error of the link.
FoundOutlets find_outlets(const LinkArguments& arguments);

}  // namespace gsbench::cli
