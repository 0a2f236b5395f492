// The adapter for Paho's MQTT client. Paho's types and exceptions do not leave it.
#pragma once

#include "arrivals.hpp"
#include <link_mqtt/broker_url.hpp>
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

  // Connects; from then on, Paho reconnects after each loss. Blocks up to 10 s, and 6 s more to
  // find the reason why it cannot.
  drivers::Status connect();
  // Subscribes now and after each reconnection. Blocks up to 5 s.
  drivers::Status subscribe(std::vector<std::string> filters);
  // Does not wait for the broker, except up to 0.5 s for room in the queue. A failure is noted as a
  // fault of the outlet.
  void publish(std::size_t outlet, const std::string& topic,
               const std::vector<std::uint8_t>& message);

 private:
  // Called by Paho, from its own threads.
  void connected(const std::string&) override;
  void connection_lost(const std::string&) override;
  void message_arrived(mqtt::const_message_ptr message) override;
  void on_failure(const mqtt::token& token) override;
  void on_success(const mqtt::token&) override {}

  // Waits for the subscriptions after a reconnection. The broker counts as back only when it has
  // confirmed all of them. Until then, it may drop messages.
  class Resubscription final : public mqtt::iaction_listener {
   public:
    explicit Resubscription(BrokerConnection& connection) : connection_(connection) {}
    void begin(std::size_t filters) { left_ = filters; }
    void on_success(const mqtt::token&) override;
    // Refused; or the connection is lost again, and the next one subscribes again.
    void on_failure(const mqtt::token& token) override;

   private:
    BrokerConnection& connection_;
    std::atomic<std::size_t> left_{0};
  };

  mqtt::connect_options connect_options() const;
  void end_session();
  std::vector<std::string> filters();
  std::string why_not_connected(const std::string& unless_known) const;

  const MqttOptions& options_;
  Arrivals& arrivals_;
  const BrokerUrl broker_;  // port 0: the URL cannot be read
  std::mutex mutex_;
  std::vector<std::string> filters_;
  std::atomic<bool> lost_{false};
  Resubscription resubscription_{*this};
  mqtt::async_client client_;  // last: its threads end before the members they use
};

}  // namespace gsbench::link
