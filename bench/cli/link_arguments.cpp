#include "link_arguments.hpp"

#include <stdexcept>

#include <profile/station_spec.hpp>
#include <station/stations.hpp>
#include <transport/transport.hpp>

namespace gsbench::cli {
namespace {

// Of all the ports of a machine those that cannot be opened are of no interest; of those that
// somebody named they are a mistake.
void require_ports(const std::vector<std::string>& named) {
  for (const std::string& port : named) {
    const drivers::Status there = transport::check_port(port);
    if (!there.ok()) {
      throw profile::ConfigurationError(there.error());
    }
  }
}

}  // namespace

void add_link_options(CLI::App& command, LinkArguments& arguments) {
  CLI::Option* station = command.add_option("--station", arguments.station,
                                            "A station file, or the name of a shipped one");
  command
      .add_option("--port", arguments.ports,
                  "A serial port, or tcp://host:port; may be given more than once")
      ->excludes(station);
}

std::unique_ptr<link::Link> make_link(const LinkArguments& arguments) {
  profile::StationSpec spec;
  if (!arguments.station.empty()) {
    spec = profile::load_station(arguments.station);
    if (spec.kind != profile::StationKind::kPhysical) {
      throw profile::ConfigurationError(spec.path +
                                        ": its outlets are there only while a run plays to them");
    }
    require_ports(spec.serial_ports);
  } else {
    require_ports(arguments.ports);
    spec.serial_ports = arguments.ports.empty() ? transport::serial_ports() : arguments.ports;
    if (spec.serial_ports.empty()) {
      throw profile::ConfigurationError(
          "this machine has no serial port; name a station with --station");
    }
  }
  return station::make_link(spec, arguments.station.empty() && arguments.ports.empty());
}

std::vector<link::OutletPresence> open_link(link::Link& link) {
  const auto present = link.open();
  if (!present.ok()) {
    throw std::runtime_error(present.error());
  }
  return present.value();
}

}  // namespace gsbench::cli
