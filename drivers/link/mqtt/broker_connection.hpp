// Paho's client behind words of our own: nothing of it, its exceptions least, goes past here.
#pragma once

#include "arrivals.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <mqtt/async_client.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace gsbench::link {

class BrokerConnection final : private mqtt::callback, private mqtt::iaction_listener {
 public:
  BrokerConnection(const MqttOptions& options, Arrivals& arrivals);
  ~BrokerConnection() override;

  // Connects, and from then on again and again where it is lost.
  drivers::Status connect();
  // Also after each time the connection was lost.
  drivers::Status subscribe(std::vector<std::string> filters);
  // Does not wait. What comes of it is noted with the outlet where it is bad.
  void publish(std::size_t outlet, const std::string& topic,
               const std::vector<std::uint8_t>& message);

 private:
  // What Paho calls, from threads of its own.
  void connected(const std::string&) override;
  void connection_lost(const std::string&) override;
  void message_arrived(mqtt::const_message_ptr message) override;
  void on_failure(const mqtt::token& token) override;
  void on_success(const mqtt::token&) override {}

  // The broker is back once it has answered the last subscription: what it gets before, it may
  // have for nobody.
  class Resubscription final : public mqtt::iaction_listener {
   public:
    explicit Resubscription(BrokerConnection& connection) : connection_(connection) {}
    void begin(std::size_t filters) { left_ = filters; }
    void on_success(const mqtt::token&) override;
    void on_failure(const mqtt::token&) override {}  // lost again; the next connection asks again

   private:
    BrokerConnection& connection_;
    std::atomic<std::size_t> left_{0};
  };

  mqtt::connect_options connect_options() const;
  std::vector<std::string> filters();
  std::string why_not_connected(const mqtt::exception& error);

  const MqttOptions& options_;
  Arrivals& arrivals_;
  std::mutex mutex_;
  std::vector<std::string> filters_;
  std::atomic<bool> lost_{false};
  Resubscription resubscription_{*this};
  mqtt::async_client client_;  // last: its threads end before what they use
};

}  // namespace gsbench::link
