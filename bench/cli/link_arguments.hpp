// Where to look for outlets, for commands that only talk to them.
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

// The station's outlets, else those on the named ports, else those on every serial port there is:
// then one without an outlet is left out. Blocks for some seconds where one does not answer. Throws
// profile::ConfigurationError where there is nowhere to look, or a named port is not there, and
// std::runtime_error with what the link says.
FoundOutlets find_outlets(const LinkArguments& arguments);

}  // namespace gsbench::cli
