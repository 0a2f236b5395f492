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
  std::vector<std::string> ids;
  Status done = opened_->connection.connect();
  if (done.ok()) {
    done = find_outlets(ids);
  }
  if (!done.ok()) {
    close();
    return Error{done.error()};
  }
  auto answered = identify(ids);
  if (!answered.ok()) {
    close();
  }
  return answered;
}

Status MqttLink::find_outlets(std::vector<std::string>& ids) {
  std::vector<std::string> filters;
  for (const std::string& id : options_.outlets) {
    filters.push_back(hello_topic(id));
    filters.push_back(up_topic(id));
  }
  if (filters.empty()) {
    filters = {hello_topic("+"), up_topic("+")};
  }
  Status subscribed = opened_->connection.subscribe(std::move(filters));
  if (!subscribed.ok()) {
    return subscribed;
  }
  const auto time = options_.outlets.empty() ? options_.search : options_.patience;
  const auto found =
      opened_->arrivals.wait_for_hellos(options_.outlets, steady_clock::now() + time);
  for (const std::string& id : options_.outlets) {
    if (std::find(found.begin(), found.end(), id) == found.end()) {
      return Error{"outlet \"" + id + "\" is not on the broker " + options_.url};
    }
  }
  ids = options_.outlets.empty() ? found : options_.outlets;
  return Done{};
}

Result<std::vector<OutletPresence>> MqttLink::identify(const std::vector<std::string>& ids) {
  opened_->arrivals.expect(ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    opened_->down_topics.push_back(down_topic(ids[i]));
    const Status sent = send(i, gs::wire::identify());
    if (!sent.ok()) {
      return Error{sent.error()};
    }
  }
  opened_->arrivals.wait_for_answers(steady_clock::now() + options_.patience);
  const auto hellos = opened_->arrivals.settle();
  if (!hellos.ok()) {
    return Error{hellos.error() + " (broker " + options_.url + ')'};
  }
  std::vector<OutletPresence> outlets;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    outlets.push_back({ids[i], options_.url, hellos.value()[i]});
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
