#include <link_framed/framed_link.hpp>
#include <link_mqtt/mqtt_link.hpp>

#include <fstream>

#include <keys/error.hpp>
#include <link/combined_link.hpp>
#include <station/physical_outlets.hpp>

namespace gsbench::station {
namespace {

std::string first_line(const std::string& path) {
  std::string line;
  if (!std::getline(std::ifstream(path), line)) {
    throw keys::ConfigurationError(path + ": no password can be read");
  }
  return line;
}

}  // namespace

std::unique_ptr<link::Link> make_link(const PhysicalOutlets& outlets, bool looking) {
  std::vector<std::unique_ptr<link::Link>> links;
  if (!outlets.serial_ports.empty()) {
    link::FramedOptions options;
    options.ports = outlets.serial_ports;
    options.baud = outlets.baud;
    options.skip_unusable = looking;
    links.push_back(std::make_unique<link::FramedLink>(options));
  }
  if (!outlets.broker.url.empty()) {
    link::MqttOptions options;
    options.url = outlets.broker.url;
    options.ca_file = outlets.broker.ca_file;
    options.user = outlets.broker.user;
    options.password = outlets.broker.password_file.empty()
                           ? outlets.broker.password
                           : first_line(outlets.broker.password_file);
    options.outlets = outlets.broker.outlets;
    links.push_back(std::make_unique<link::MqttLink>(options));
  }
  return std::make_unique<link::CombinedLink>(std::move(links));
}

}  // namespace gsbench::station
