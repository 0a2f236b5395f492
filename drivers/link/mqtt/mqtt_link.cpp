#include "arrivals.hpp"
#include "broker_connection.hpp"
#include <link_mqtt/mqtt_link.hpp>

#include <utility>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;

class MqttLink::Opened {
 public:
  explicit Opened(const MqttOptions& options) : connection(options, arrivals) {}

  Arrivals arrivals;
  BrokerConnection connection;  // after `arrivals`, which it uses
};

MqttLink::MqttLink(MqttOptions options) : options_(std::move(options)) {}

MqttLink::~MqttLink() {
  close();
}

Status MqttLink::open() {
  close();
  std::vector<std::string> filters;
  for (const std::string& id : options_.outlets) {
    filters.push_back(topic(id, kHello));
    filters.push_back(topic(id, kUp));
  }
  if (filters.empty()) {
    filters = {topic("+", kHello), topic("+", kUp)};
  }
  opened_ = std::make_unique<Opened>(options_);
  Status done = opened_->connection.connect();
  if (done.ok()) {
    done = opened_->connection.subscribe(std::move(filters));
  }
  if (done.ok()) {
    opened_->arrivals.expect(options_.outlets);
  } else {
    close();
  }
  return done;
}

Status MqttLink::send(const std::string& id, const gs::wire::Downlink& message) {
  const auto outlet = opened_ ? opened_->arrivals.find(id) : std::nullopt;
  if (!outlet) {
    return Error{"the link to the broker " + options_.url + " has no outlet " + id};
  }
  send(*outlet, message);
  return Done{};
}

void MqttLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  if (const auto bytes = opened_->arrivals.encode(outlet, message); !bytes.empty()) {
    opened_->connection.publish(outlet, topic(opened_->arrivals.id(outlet), kDown), bytes);
  }
}

Status MqttLink::poll(Happenings& happenings) {
  if (!opened_) {
    return Error{"the link to the broker " + options_.url + " is not open"};
  }
  Happenings arrived;
  arrived.messages.swap(happenings.messages);
  opened_->arrivals.hand_over(arrived);
  for (Change& change : arrived.changes) {
    std::visit([&](auto& one) { one.where = options_.url; }, change);
  }
  for (Fault& fault : arrived.faults) {
    fault.where = options_.url;
  }
  arrived.messages.swap(happenings.messages);
  happenings.append(arrived);
  // `identify` goes out before the caller sees these outlets and can send to them.
  for (const std::size_t outlet : opened_->arrivals.take_newcomers()) {
    send(outlet, gs::wire::identify());
  }
  return Done{};
}

std::vector<Fault> MqttLink::missing() {
  return opened_ ? opened_->arrivals.missing(options_.outlets) : std::vector<Fault>();
}

void MqttLink::close() noexcept {
  opened_.reset();
}

}  // namespace gsbench::link
