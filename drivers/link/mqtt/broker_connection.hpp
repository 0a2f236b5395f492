// Paho's client behind words of our own: nothing of it, its exceptions least, goes past here.
#pragma once

#include "arrivals.hpp"
#include <link_mqtt/mqtt_link.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace gsbench::link {

class BrokerConnection {
 public:
  BrokerConnection(const MqttOptions& options, Arrivals& arrivals);
  ~BrokerConnection();

  // Connects, and from then on again and again where it is lost.
  drivers::Status connect();
  // Also after each time the connection was lost.
  drivers::Status subscribe(std::vector<std::string> filters);
  // Does not wait. What comes of it is noted with the outlet where it is bad.
  void publish(std::size_t outlet, const std::string& topic,
               const std::vector<std::uint8_t>& message);
  void close() noexcept;

 private:
  class Client;

  std::unique_ptr<Client> client_;
};

}  // namespace gsbench::link
