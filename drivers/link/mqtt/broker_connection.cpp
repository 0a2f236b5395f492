#include "broker_connection.hpp"

#include "broker_trial.hpp"
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>
#include <utility>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr auto kToConnect = std::chrono::seconds(10);
constexpr auto kToDisconnect = std::chrono::seconds(1);
constexpr auto kToEndSession = std::chrono::seconds(3);  // Paho connects again after 1.1 s
constexpr auto kToSubscribe = std::chrono::seconds(5);
constexpr auto kToFindRoom = std::chrono::milliseconds(500);
constexpr int kKeepAlive_s = 5;      // a silent broker counts as lost after 1.5 intervals
constexpr int kKeepSession_s = 60;   // the broker stores messages for a disconnected bench
constexpr int kMostWaiting = 10000;  // messages to outlets that wait for a connection
constexpr int kMostInFlight = 65535;
constexpr int kNoRoom = MQTTASYNC_MAX_BUFFERED_MESSAGES;

// Paho checks the host of a certificate with the brackets of an IPv6 address, which no certificate
// has. It takes such an address without brackets, too: the port follows the last colon.
std::string paho_url(const BrokerUrl& broker) {
  return (broker.tls ? "ssl://" : "tcp://") + broker.host + ':' + std::to_string(broker.port);
}

// New for each open(): no earlier session is resumed.
std::string new_client_id() {
  std::random_device device;
  return "gsbench-" + std::to_string(device()) + '-' + std::to_string(device());
}

// Paho returns the broker's reason code as if it were its own error code.
bool refused_login(const mqtt::exception& error) {
  return error.get_return_code() == mqtt::ReasonCode::BAD_USER_NAME_OR_PASSWORD ||
         error.get_return_code() == mqtt::ReasonCode::NOT_AUTHORIZED;
}

// Retained messages are sent for a new subscription only, not again for one that the broker has.
mqtt::subscribe_options once() {
  return mqtt::subscribe_options(false, false, mqtt::subscribe_options::SEND_RETAINED_ON_NEW);
}

// 0: not a TCP connection.
unsigned peer_port(int descriptor) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &size) != 0) {
    return 0;
  }
  switch (peer.ss_family) {
    case AF_INET:
      return ntohs(reinterpret_cast<const sockaddr_in&>(peer).sin_port);
    case AF_INET6:
      return ntohs(reinterpret_cast<const sockaddr_in6&>(peer).sin6_port);
    default:
      return 0;
  }
}

// Sets TCP_NODELAY: without it, every other command waits 40 ms for the acknowledgement of the one
// before. Paho has no option for it and does not expose its socket, so this searches the process's
// descriptors for connections to the broker's port.
void send_at_once(unsigned port) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    const int descriptor =
        static_cast<int>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    if (peer_port(descriptor) == port) {
      const int yes = 1;
      setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    }
  }
}

}  // namespace

BrokerConnection::BrokerConnection(const MqttOptions& options, Arrivals& arrivals)
    : options_(options),
      arrivals_(arrivals),
      broker_(read_broker_url(options.url).value_or(BrokerUrl())),
      client_(paho_url(broker_), new_client_id(),
              mqtt::create_options(MQTTVERSION_5, kMostWaiting)) {
  // By default, Paho formats and stores a trace of every packet.
  MQTTAsync_setTraceLevel(MQTTASYNC_TRACE_ERROR);
  client_.set_callback(*this);
}

mqtt::connect_options BrokerConnection::connect_options() const {
  mqtt::connect_options asked;
  asked.set_mqtt_version(MQTTVERSION_5);
  asked.set_clean_start(!options_.keeps_session);
  asked.set_properties(
      {{mqtt::property::SESSION_EXPIRY_INTERVAL, options_.keeps_session ? kKeepSession_s : 0},
       {mqtt::property::RECEIVE_MAXIMUM, kMostInFlight}});
  asked.set_keep_alive_interval(kKeepAlive_s);
  asked.set_connect_timeout(kToConnect);
  asked.set_automatic_reconnect(1, 2);
  asked.set_max_inflight(kMostInFlight);
  asked.set_user_name(options_.user);
  asked.set_password(options_.password);
  if (broker_.tls) {
    mqtt::ssl_options tls;
    tls.set_trust_store(options_.ca_file);
    tls.set_enable_server_cert_auth(true);
    tls.set_verify(true);
    // No error handler: Paho 1.2.0 keeps the address of a copy that no longer exists when it is
    // used.
    asked.set_ssl(tls);
  }
  return asked;
}

Status BrokerConnection::connect() {
  if (broker_.port == 0) {
    return Error{"\"" + options_.url + "\" is not the address of a broker"};
  }
  try {
    const mqtt::token_ptr connecting = client_.connect(connect_options());
    if (connecting->wait_for(kToConnect)) {
      return Done{};
    }
    return Error{why_not_connected("does not answer")};
  } catch (const mqtt::exception& error) {
    if (!refused_login(error)) {
      return Error{why_not_connected("cannot be reached: " + error.to_string())};
    }
    return Error{"the broker " + options_.url + " refuses " +
                 (options_.user.empty()
                      ? "a login without a user name"
                      : "the user name \"" + options_.user + "\" or the password")};
  }
}

// `unless_known`: the reason if a second attempt finds none.
std::string BrokerConnection::why_not_connected(const std::string& unless_known) const {
  const std::string trouble = trouble_with(broker_, options_.ca_file);
  return "the broker " + options_.url + ' ' + (trouble.empty() ? unless_known : trouble);
}

// A copy, so that the lock is not held during calls into Paho, whose callbacks hold Paho's locks.
std::vector<std::string> BrokerConnection::filters() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return filters_;
}

Status BrokerConnection::subscribe(std::vector<std::string> wanted) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    filters_ = std::move(wanted);
  }
  const auto until = std::chrono::steady_clock::now() + kToSubscribe;
  try {
    std::vector<mqtt::token_ptr> asked;
    // One by one: Paho 1.2.0 crashes if several are subscribed at once with options.
    for (const std::string& filter : filters()) {
      asked.push_back(client_.subscribe(filter, 1, once()));
    }
    for (const mqtt::token_ptr& one : asked) {
      if (!one->wait_until(until)) {
        return Error{"the broker " + options_.url + " does not answer a subscription"};
      }
    }
    return Done{};
  } catch (const mqtt::exception& error) {
    return Error{"the broker " + options_.url + " refuses a subscription: " + error.to_string()};
  }
}

void BrokerConnection::publish(std::size_t outlet, const std::string& topic,
                               const std::vector<std::uint8_t>& message) {
  const auto until = std::chrono::steady_clock::now() + kToFindRoom;
  const auto payload =
      mqtt::make_message(topic, static_cast<const void*>(message.data()), message.size(), 1, false);
  // Paho's context is a pointer; it carries the outlet's number instead.
  void* const place = reinterpret_cast<void*>(outlet);  // NOLINT(performance-no-int-to-ptr)
  while (true) {
    try {
      client_.publish(payload, place, *this);
      return;
    } catch (const mqtt::exception& error) {
      if (error.get_return_code() != kNoRoom || std::chrono::steady_clock::now() > until) {
        return arrivals_.note(outlet, "cannot be sent a message: " + error.to_string());
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

BrokerConnection::~BrokerConnection() {
  try {
    client_.disable_callbacks();
    if (client_.is_connected()) {
      client_.disconnect(kToDisconnect)->wait_for(kToDisconnect);
      if (options_.keeps_session) {
        end_session();
      }
    }
  } catch (const mqtt::exception&) {
    return;  // was not connected
  }
}

// Otherwise the broker would store messages for 60 s that nobody wants. A session may also be ended
// by a property of the disconnection, but Paho 1.2.0 does not send it.
void BrokerConnection::end_session() {
  mqtt::connect_options asked = connect_options();
  asked.set_clean_start(true);
  asked.set_properties({{mqtt::property::SESSION_EXPIRY_INTERVAL, 0}});
  asked.set_automatic_reconnect(false);
  if (client_.connect(asked)->wait_for(kToEndSession)) {
    client_.disconnect(kToDisconnect)->wait_for(kToDisconnect);
  }
}

void BrokerConnection::connected(const std::string&) {
  send_at_once(broker_.port);
  if (!lost_) {
    return;  // the first connection: the caller subscribes
  }
  const std::vector<std::string> wanted = filters();
  resubscription_.begin(wanted.size());
  try {
    for (const std::string& filter : wanted) {
      client_.subscribe(filter, 1, nullptr, resubscription_, once());
    }
  } catch (const mqtt::exception&) {
    return;  // lost again; the next connection subscribes again
  }
}

void BrokerConnection::Resubscription::on_success(const mqtt::token&) {
  if (--left_ == 0 && connection_.lost_.exchange(false)) {
    connection_.arrivals_.note_all("is connected to its broker again");
  }
}

void BrokerConnection::Resubscription::on_failure(const mqtt::token& token) {
  const int reason = token.get_reason_code();
  if (reason < mqtt::ReasonCode::UNSPECIFIED_ERROR || !connection_.lost_.exchange(false)) {
    return;
  }
  connection_.arrivals_.note_all(
      "is not heard any more: the broker " +
      (reason == mqtt::ReasonCode::NOT_AUTHORIZED
           ? "does not allow the user \"" + connection_.options_.user +
                 "\" to subscribe to its messages"
           : "refuses the subscription, MQTT reason code " + std::to_string(reason)));
}

void BrokerConnection::connection_lost(const std::string&) {
  if (!lost_.exchange(true)) {
    arrivals_.note_all("lost its broker: the connection to " + options_.url + " broke");
  }
}

void BrokerConnection::message_arrived(mqtt::const_message_ptr message) {
  const mqtt::binary& payload = message->get_payload();
  arrivals_.take(message->get_topic(), reinterpret_cast<const std::uint8_t*>(payload.data()),
                 payload.size(), message->is_retained());
}

void BrokerConnection::on_failure(const mqtt::token& token) {
  const int reason = token.get_reason_code();
  std::string why = "MQTT reason code " + std::to_string(reason);
  if (reason == mqtt::ReasonCode::SUCCESS) {
    why = "the connection to the broker broke before the broker confirmed it";
  } else if (reason == mqtt::ReasonCode::NOT_AUTHORIZED) {
    why = "the broker does not allow the user \"" + options_.user + "\" to publish it";
  }
  arrivals_.note(reinterpret_cast<std::uintptr_t>(token.get_user_context()),
                 "was not sent a message: " + why);
}

}  // namespace gsbench::link
