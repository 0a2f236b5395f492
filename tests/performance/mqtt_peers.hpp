// MQTT clients for comparison with the bench's link: they only receive.
#pragma once

#include <mosquitto.h>
#include <test_support/temporary_folder.hpp>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include <emulation/private_broker.hpp>

namespace gsbench::performance {

// A libmosquitto client in its own thread.
class RawClient {
 public:
  using OnMessage = std::function<void(const mosquitto_message&)>;

  // Blocks until it is subscribed.
  RawClient(const emulation::PrivateBroker& broker, const emulation::Login& login,
            const std::string& topic, OnMessage on_message);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  // With QoS 1.
  void publish(const std::string& topic, const void* bytes, int size);

 private:
  OnMessage on_message_;
  std::string topic_;
  std::atomic<bool> subscribed_{false};
  mosquitto* client_;
};

// Sends `messages` messages of `size` bytes from mosquitto_pub to mosquitto_sub; returns
// messages/s.
double programs_per_second(const emulation::PrivateBroker& broker, const std::string& outlet,
                           std::size_t messages, std::size_t size,
                           const test::TemporaryFolder& folder);

}  // namespace gsbench::performance
