// Outlets that are there: on serial ports and on a broker.
#pragma once

#include <link_framed/framed_link.hpp>
#include <link_mqtt/mqtt_link.hpp>

#include <memory>
#include <string>

#include <link/link.hpp>

namespace gsbench::station {

struct PhysicalOutlets {
  link::FramedOptions serial;      // without ports: none
  link::MqttOptions mqtt;          // without a URL: none
  std::string password_file = {};  // holds the broker's password in the first line; empty: as above
};

// Throws keys::ConfigurationError where the password cannot be read.
std::unique_ptr<link::Link> make_link(PhysicalOutlets outlets);

}  // namespace gsbench::station
