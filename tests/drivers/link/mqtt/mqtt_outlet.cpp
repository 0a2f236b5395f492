#include "mqtt_outlet.hpp"

#include <test_support/waiting.hpp>
#include <wire_test/downlinks.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace gsbench::test {

gs::host::MqttOptions options_of(const emulation::PrivateBroker& broker, const std::string& id,
                                 std::uint32_t instance) {
  const emulation::Login& login = broker.outlet(id);
  return {broker.url(), broker.ca_file(), login.user, login.password, id, instance};
}

MqttOutlet::MqttOutlet(const emulation::PrivateBroker& broker, const std::string& id,
                       std::uint32_t instance) {
  static std::atomic<std::uint32_t> made{0};
  identity_.start_number = 1000 * ++made;
  endpoint_.emplace(app_, carrier_);
  gs::app::set_text(identity_.id, id.c_str());
  gs::app::set_text(identity_.board, "test");
  identity_.instance = instance;
  std::string why;
  if (!carrier_.start(options_of(broker, id, instance), why)) {
    throw std::runtime_error(why);
  }
  app_.start({}, identity_, nullptr, *endpoint_);
  const bool connected = until([this] {
    carrier_.serve();
    return carrier_.connected();
  });
  if (!connected) {
    throw std::runtime_error("outlet " + id + ": " + carrier_.trouble());
  }
  thread_ = std::thread([this] { run(); });
}

MqttOutlet::~MqttOutlet() {
  if (thread_.joinable()) {
    stop_answering();
  }
}

void MqttOutlet::run() {
  while (!ending_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard<std::mutex> lock(mutex_);
    serve();
  }
}

void MqttOutlet::serve() {
  carrier_.serve();
  if (carrier_.take_reconnected()) {
    app_.receive(gs::wire::identify(), *endpoint_);
  }
  app_.note_unsent(carrier_.take_unsent());
  std::vector<std::uint8_t> message;
  while (carrier_.take(message)) {
    endpoint_->receive(message.data(), message.size());
    received_.push_back(message);
  }
}

void MqttOutlet::receive_all_again() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::vector<std::uint8_t>& message : received_) {
    endpoint_->receive(message.data(), message.size());
  }
}

void MqttOutlet::take_samples(std::size_t count) {
  constexpr double kRadiansPerSample = 2.0 * 3.14159265358979 * 50.0 / 8000.0;
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::int16_t> samples(count);
  for (std::int16_t& sample : samples) {
    sample = static_cast<std::int16_t>(
        21845.0 * std::cos(kRadiansPerSample * static_cast<double>(taken_++ % 160)));
  }
  app_.feed(samples.data(), samples.size(), *endpoint_);
}

void MqttOutlet::report_status() {
  take_samples(1);
  const std::lock_guard<std::mutex> lock(mutex_);
  app_.receive(gs::wire::test::downlink(gs::wire::DownlinkKind::kAskStatus), *endpoint_);
}

void MqttOutlet::stop_answering() {
  ending_ = true;
  thread_.join();
}

void MqttOutlet::restart() {
  const std::lock_guard<std::mutex> lock(mutex_);
  endpoint_.emplace(app_, carrier_);
  ++identity_.start_number;
  app_.start({}, identity_, nullptr, *endpoint_);
}

bool MqttOutlet::relay_closed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return app_.relay_closed();
}

bool MqttOutlet::connected() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return carrier_.connected();
}

}  // namespace gsbench::test
