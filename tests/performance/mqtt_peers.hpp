// What the bench's link to a broker is measured beside: clients that do no more than receive.
#pragma once

#include <mosquitto.h>
#include <test_support/temporary_folder.hpp>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include <emulation/private_broker.hpp>

namespace gsbench::performance {

// One of libmosquitto, in a thread of its own.
class RawClient {
 public:
  using OnMessage = std::function<void(const mosquitto_message&)>;

  // Subscribed when this returns.
  RawClient(const emulation::PrivateBroker& broker, const emulation::Login& login,
            const std::string& topic, OnMessage on_message);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  // Acknowledged.
  void publish(const std::string& topic, const void* bytes, int size);

 private:
  OnMessage on_message_;
  std::string topic_;
  std::atomic<bool> subscribed_{false};
  mosquitto* client_;
};

// So many messages of one size from mosquitto_pub to mosquitto_sub: how many a second.
double programs_per_second(const emulation::PrivateBroker& broker, const std::string& outlet,
                           std::size_t messages, std::size_t size,
                           const test::TemporaryFolder& folder);

}  // namespace gsbench::performance
