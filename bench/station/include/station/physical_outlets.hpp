// Outlets that are there: on serial ports and on a broker.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <transport/transport.hpp>

namespace gsbench::station {

struct Broker {
  std::string url;  // mqtts://host:port, mqtt://host:port without TLS; empty: none
  std::string ca_file;
  std::string user;
  std::string password_file;         // holds it in the first line
  std::vector<std::string> outlets;  // ids; empty: all that are found
  std::string password = {};         // in place of such a file
};

struct PhysicalOutlets {
  std::vector<std::string> serial_ports;
  int baud = transport::kBaud;
  Broker broker;
};

// `looking`: ports that cannot be opened are left out, not an error. Throws
// keys::ConfigurationError where the password cannot be read.
std::unique_ptr<link::Link> make_link(const PhysicalOutlets& outlets, bool looking);

}  // namespace gsbench::station
