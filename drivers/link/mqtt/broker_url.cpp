#include <link_mqtt/broker_url.hpp>

#include <transport/address.hpp>

namespace gsbench::link {

std::optional<BrokerUrl> read_broker_url(const std::string& text) {
  const auto address = transport::read_address(text);
  if (!address || (address->scheme != "mqtt" && address->scheme != "mqtts")) {
    return std::nullopt;
  }
  return BrokerUrl{address->scheme == "mqtts", address->host, address->port};
}

std::string text_of(const BrokerUrl& url) {
  return transport::text_of({url.tls ? "mqtts" : "mqtt", url.host, url.port});
}

}  // namespace gsbench::link
