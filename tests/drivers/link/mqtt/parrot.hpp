// An outlet on a broker that can say one hello only, such as one that no firmware sends.
#pragma once

#include "mqtt_outlet.hpp"

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <wire/codec.hpp>

namespace gsbench::test {

// Sends the hello once, and again for each message that it receives. Stays connected.
class Parrot {
 public:
  Parrot(const emulation::PrivateBroker& broker, const std::string& id,
         const gs::wire::Uplink& hello) {
    std::string why;
    EXPECT_TRUE(carrier_.start(options_of(broker, id, 1), why)) << why;
    size_ = gs::wire::encode(hello, 0, bytes_, sizeof bytes_);
    carrier_.send(bytes_, size_);
    thread_ = std::thread([this] { run(); });
  }
  ~Parrot() {
    if (thread_.joinable()) {
      stop_answering();
    }
  }

  void stop_answering() {
    ending_ = true;
    thread_.join();
  }

 private:
  void run() {
    std::vector<std::uint8_t> message;
    while (!ending_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      carrier_.serve();
      while (carrier_.take(message)) {
        carrier_.send(bytes_, size_);
      }
    }
  }

  gs::host::MqttCarrier carrier_;
  std::uint8_t bytes_[gs::wire::kLongestMessage] = {};
  std::size_t size_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace gsbench::test
