// The address of an MQTT broker: mqtts://host:port with TLS, mqtt://host:port without.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gsbench::link {

struct BrokerUrl {
  bool tls = false;
  std::string host;  // a name or an address; an IPv6 address has no brackets
  std::uint16_t port = 0;
};

// As transport::read_address() takes it: "mqtts://[::1]:8883". nullopt: `text` has another form.
std::optional<BrokerUrl> read_broker_url(const std::string& text);

// The same text for all forms of an address: "mqtts://[::1]:8883".
std::string text_of(const BrokerUrl& url);

}  // namespace gsbench::link
