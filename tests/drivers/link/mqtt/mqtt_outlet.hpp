// An outlet on a broker: the firmware with the host board's MQTT code, on a thread of its own.
#pragma once

#include <mqtt_carrier.hpp>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <app/endpoint.hpp>
#include <emulation/private_broker.hpp>

namespace gsbench::test {

gs::host::MqttOptions options_of(const emulation::PrivateBroker& broker, const std::string& id,
                                 std::uint32_t instance);

class MqttOutlet {
 public:
  // Blocks until it is connected. Throws std::runtime_error if it cannot connect.
  MqttOutlet(const emulation::PrivateBroker& broker, const std::string& id,
             std::uint32_t instance = 1);
  ~MqttOutlet();  // disconnects cleanly

  void take_samples(std::size_t count);  // of steady 50 Hz; 128 make a measurement
  void report_status();                  // after one sample, so that statuses differ
  void stop_answering();                 // stays connected but is silent
  void restart();                        // on the same connection
  void receive_all_again();              // everything that it has received
  bool relay_closed();
  bool connected();

 private:
  void run();
  void serve();

  gs::app::Identity identity_;
  gs::host::MqttCarrier carrier_;
  gs::app::Application app_;
  std::optional<gs::app::MessageEndpoint> endpoint_;
  std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> received_;
  std::uint64_t taken_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace gsbench::test
