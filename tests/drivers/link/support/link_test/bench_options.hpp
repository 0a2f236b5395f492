// Options for the bench's link to a private broker.
#pragma once

#include <link_mqtt/mqtt_link.hpp>

#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::test {

inline link::MqttOptions bench_options(const emulation::PrivateBroker& broker,
                                       const std::vector<std::string>& outlets) {
  link::MqttOptions options;
  options.url = broker.url();
  options.ca_file = broker.ca_file();
  options.user = broker.bench().user;
  options.password = broker.bench().password;
  options.outlets = outlets;
  return options;
}

}  // namespace gsbench::test
