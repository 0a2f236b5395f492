// Where to look for outlets, for commands that only talk to them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <link/link.hpp>

namespace gsbench::cli {

struct LinkArguments {
  std::string station;
  std::vector<std::string> ports;
};

void add_link_options(CLI::App& command, LinkArguments& arguments);

// To the station's outlets, else to those on the named ports, else on every serial port there is.
// Throws profile::ConfigurationError where there is nowhere to look, or a named port is not there.
std::unique_ptr<link::Link> make_link(const LinkArguments& arguments);

// Opens it; throws std::runtime_error with what the link says.
std::vector<link::OutletPresence> open_link(link::Link& link);

}  // namespace gsbench::cli
