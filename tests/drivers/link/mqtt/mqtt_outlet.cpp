#include "mqtt_outlet.hpp"

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
  endpoint_.emplace(app_, carrier_);
  gs::app::set_text(identity_.id, id.c_str());
  gs::app::set_text(identity_.board, "test");
  identity_.instance = instance;
  std::string why;
  if (!carrier_.start(options_of(broker, id, instance), why)) {
    throw std::runtime_error(why);
  }
  start_node();
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!carrier_.connected()) {
    if (std::chrono::steady_clock::now() > until) {
      throw std::runtime_error("outlet " + id + ": " + carrier_.trouble());
    }
    carrier_.wait(std::chrono::milliseconds(1));
    carrier_.serve();
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
    carrier_.wait(std::chrono::milliseconds(1));
    const std::lock_guard<std::mutex> lock(mutex_);
    serve();
  }
}

void MqttOutlet::serve() {
  carrier_.serve();
  if (carrier_.take_reconnected()) {
    gs::wire::Downlink who;
    who.kind = gs::wire::DownlinkKind::kIdentify;
    app_.receive(who, *endpoint_);
  }
  std::vector<std::uint8_t> message;
  while (carrier_.take(message)) {
    endpoint_->receive(message.data(), message.size());
  }
}

void MqttOutlet::start_node() {
  app_.start({}, identity_, nullptr, *endpoint_);
}

void MqttOutlet::with_node(
    const std::function<void(gs::app::Application&, gs::app::Outbox&)>& act) {
  const std::lock_guard<std::mutex> lock(mutex_);
  act(app_, *endpoint_);
}

void MqttOutlet::take_samples(std::size_t count) {
  with_node([&](gs::app::Application& node, gs::app::Outbox& outbox) {
    constexpr double kRadiansPerSample = 2.0 * 3.14159265358979 * 50.0 / 8000.0;
    std::vector<std::int16_t> samples(count);
    for (std::int16_t& sample : samples) {
      sample = static_cast<std::int16_t>(
          21845.0 * std::cos(kRadiansPerSample * static_cast<double>(taken_++ % 160)));
    }
    node.feed(samples.data(), samples.size(), outbox);
  });
}

void MqttOutlet::report_status() {
  take_samples(1);
  with_node([](gs::app::Application& node, gs::app::Outbox& outbox) {
    gs::wire::Downlink ask;
    ask.kind = gs::wire::DownlinkKind::kAskStatus;
    node.receive(ask, outbox);
  });
}

void MqttOutlet::stop_answering() {
  ending_ = true;
  thread_.join();
}

void MqttOutlet::restart() {
  const std::lock_guard<std::mutex> lock(mutex_);
  endpoint_.emplace(app_, carrier_);
  start_node();
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
