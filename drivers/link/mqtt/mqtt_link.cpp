#include "arrivals.hpp"
#include "broker_connection.hpp"
#include <link_mqtt/mqtt_link.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using std::chrono::steady_clock;

class MqttLink::Opened {
 public:
  explicit Opened(const MqttOptions& options) : connection(options, arrivals) {}

  Arrivals arrivals;
  BrokerConnection connection;  // after what it fills
  std::vector<std::string> down_topics;
};

MqttLink::MqttLink(MqttOptions options) : options_(std::move(options)) {}

MqttLink::~MqttLink() {
  close();
}

Result<std::vector<OutletPresence>> MqttLink::open() {
  close();
  opened_ = std::make_unique<Opened>(options_);
  Status done = opened_->connection.connect();
  if (done.ok()) {
    done = look_for_outlets();
  }
  if (!done.ok()) {
    close();
    return Error{done.error()};
  }
  auto answered = identify();
  if (!answered.ok()) {
    close();
  }
  return answered;
}

Status MqttLink::look_for_outlets() {
  std::vector<std::string> filters;
  for (const std::string& id : options_.outlets) {
    filters.push_back(hello_topic(id));
    filters.push_back(up_topic(id));
  }
  if (filters.empty()) {
    filters = {hello_topic("+"), up_topic("+")};
  }
  return opened_->connection.subscribe(std::move(filters));
}

Result<std::vector<OutletPresence>> MqttLink::identify() {
  Arrivals& arrivals = opened_->arrivals;
  const bool named = !options_.outlets.empty();
  const auto found = arrivals.wait_for_hellos(
      options_.outlets, steady_clock::now() + (named ? options_.patience : options_.search));
  const std::vector<std::string>& ids = named ? options_.outlets : found;
  arrivals.expect(ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    opened_->down_topics.push_back(down_topic(ids[i]));
    if (std::find(found.begin(), found.end(), ids[i]) == found.end()) {
      arrivals.leave_out(i, "is not on the broker");
    }
    const Status sent = send(i, gs::wire::identify());
    if (!sent.ok()) {
      return Error{sent.error()};
    }
  }
  arrivals.wait_for_answers(steady_clock::now() + options_.patience);
  std::vector<OutletPresence> outlets = arrivals.settle();
  for (OutletPresence& outlet : outlets) {
    outlet.where = options_.url;
  }
  return outlets;
}

Status MqttLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  if (!opened_ || outlet >= opened_->down_topics.size()) {
    return Error{"the link to the broker " + options_.url + " has no outlet " +
                 std::to_string(outlet)};
  }
  const auto bytes = opened_->arrivals.encode(outlet, message);
  if (!bytes.empty()) {
    opened_->connection.publish(outlet, opened_->down_topics[outlet], bytes);
  }
  return Done{};
}

Status MqttLink::poll(std::vector<Received>& messages, std::vector<Fault>& faults) {
  if (!opened_) {
    return Error{"the link to the broker " + options_.url + " is not open"};
  }
  opened_->arrivals.hand_over(messages, faults);
  return Done{};
}

void MqttLink::close() noexcept {
  opened_.reset();
}

}  // namespace gsbench::link
