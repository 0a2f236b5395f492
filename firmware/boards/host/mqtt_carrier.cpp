#include "mqtt_carrier.hpp"

#include <mosquitto.h>
#include <mqtt_protocol.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include <wire/cbor.hpp>
#include <wire/messages.hpp>

namespace gs::host {

using std::chrono::steady_clock;

namespace {

constexpr int kKeepAlive_s = 10;
constexpr auto kLongestAttempt = std::chrono::seconds(8);
constexpr auto kBetweenInterrupts = std::chrono::milliseconds(100);
constexpr auto kBetweenUpkeep = std::chrono::milliseconds(100);
constexpr std::size_t kMostWaiting = 1000;  // messages of up to wire::kLongestMessage
constexpr int kMostInFlight = 65535;
constexpr std::size_t kMostReceived = 100;

struct Library {
  Library() { mosquitto_lib_init(); }
  ~Library() { mosquitto_lib_cleanup(); }
};

wire::UplinkKind kind_of(const std::uint8_t* message, std::size_t size) {
  wire::cbor::Reader reader(message, size);
  std::size_t items = 0;
  std::uint64_t kind = 0;
  if (!reader.array(items) || !reader.unsigned_integer(kind)) {
    kind = 0;
  }
  return static_cast<wire::UplinkKind>(kind);
}

}  // namespace

MqttCarrier::~MqttCarrier() {
  attempt_.finish();
  if (client_ == nullptr) {
    return;
  }
  mosquitto_disconnect_v5(client_, MQTT_RC_DISCONNECT_WITH_WILL_MSG, nullptr);
  mosquitto_destroy(client_);
}

bool MqttCarrier::start(const MqttOptions& options, std::string& why) {
  static const Library library;
  const bool is_address = read_address(options.url, address_);
  is_tls_ = address_.scheme == "mqtts";
  if (!is_address || !(is_tls_ || address_.scheme == "mqtt")) {
    why = '"' + options.url + "\" is not mqtts://host:port or mqtt://host:port";
    return false;
  }
  user_ = options.user;
  hello_topic_ = "gs/" + options.id + "/hello";
  up_topic_ = "gs/" + options.id + "/up";
  down_topic_ = "gs/" + options.id + "/down";
  char instance[9];
  std::snprintf(instance, sizeof instance, "%08x", static_cast<unsigned>(options.instance));
  client_ = mosquitto_new((options.id + '-' + instance).c_str(), true, this);
  if (client_ == nullptr) {
    why = "out of memory for an MQTT client";
    return false;
  }
  mosquitto_connect_v5_callback_set(client_, on_connect);
  mosquitto_disconnect_v5_callback_set(client_, on_disconnect);
  mosquitto_publish_v5_callback_set(client_, on_publish);
  mosquitto_message_v5_callback_set(client_, on_message);
  mosquitto_log_callback_set(client_, on_log);
  int error = mosquitto_int_option(client_, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5);
  const auto then = [&error](int result) { error = error == MOSQ_ERR_SUCCESS ? result : error; };
  then(mosquitto_int_option(client_, MOSQ_OPT_TCP_NODELAY, 1));
  then(mosquitto_int_option(client_, MOSQ_OPT_SEND_MAXIMUM, kMostInFlight));
  then(mosquitto_username_pw_set(client_, options.user.c_str(), options.password.c_str()));
  then(mosquitto_will_set_v5(client_, hello_topic_.c_str(), 0, nullptr, 1, true, nullptr));
  if (is_tls_) {
    if (options.ca_file.empty()) {
      why = "mqtts:// needs --ca FILE, the CA certificate that signs the broker's certificate";
      return false;
    }
    if (!tls_.start(options.ca_file, address_.host, why)) {
      why = "the CA file \"" + options.ca_file + "\" cannot be read (--ca): " + why;
      return false;
    }
    then(mosquitto_int_option(client_, MOSQ_OPT_SSL_CTX_WITH_DEFAULTS, 0));
    then(mosquitto_void_option(client_, MOSQ_OPT_SSL_CTX, tls_.context()));
  }
  if (error != MOSQ_ERR_SUCCESS) {
    why = mosquitto_strerror(error);
    return false;
  }
  return true;
}

void MqttCarrier::connect() {
  connected_ = false;
  is_answered_ = false;
  logged_.clear();
  tls_.forget_refusal();
  interrupt_ = steady_clock::now() + kLongestAttempt;
  attempt_.start([client = client_, address = address_] {
    errno = 0;
    const int error = mosquitto_connect_bind_v5(client, address.host.c_str(), address.port,
                                                kKeepAlive_s, nullptr, nullptr);
    return Outcome{error, errno == EINTR ? ETIMEDOUT : errno};
  });
}

bool MqttCarrier::send(const std::uint8_t* message, std::size_t size) {
  // A hello comes before what is kept: it has numbers of its own.
  const wire::UplinkKind kind = kind_of(message, size);
  if (connected() && (waiting_.empty() || kind == wire::UplinkKind::kHello)) {
    return publish(message, size);
  }
  if (kind == wire::UplinkKind::kHello && was_connected_) {
    return true;  // the next connection begins with a newer one
  }
  // Queued here and not in the library, which would send new messages as soon as it has a socket,
  // and repeat the older ones only after the broker has answered.
  if (kind == wire::UplinkKind::kMeasurement || waiting_.size() >= kMostWaiting) {
    return false;
  }
  waiting_.emplace_back(message, message + size);
  return true;
}

bool MqttCarrier::publish(const std::uint8_t* message, std::size_t size) {
  const wire::UplinkKind kind = kind_of(message, size);
  const bool at_least_once = kind != wire::UplinkKind::kMeasurement;
  const bool hello = kind == wire::UplinkKind::kHello;
  const int error =
      mosquitto_publish_v5(client_, nullptr, (hello ? hello_topic_ : up_topic_).c_str(),
                           static_cast<int>(size), message, at_least_once ? 1 : 0, hello, nullptr);
  // With QoS 1 the library repeats a message that was being sent when the connection broke.
  const bool kept = at_least_once && (error == MOSQ_ERR_NO_CONN || error == MOSQ_ERR_CONN_LOST);
  return error == MOSQ_ERR_SUCCESS || kept;
}

void MqttCarrier::serve() {
  const auto now = steady_clock::now();
  if (attempt_.running()) {
    if (now >= interrupt_) {
      interrupt_ = now + kBetweenInterrupts;
      attempt_.interrupt();
    }
    const std::optional<Outcome> outcome = attempt_.take();
    if (!outcome) {
      return;
    }
    next_attempt_ = now + kBetweenAttempts;
    errno = outcome->number;
    check(outcome->error);
  }
  if (descriptor() < 0) {
    if (now >= next_attempt_) {
      connect();
    }
    return;
  }
  // If the outlet does not take its messages, they wait in the socket, and then at the broker.
  if (received_.size() < kMostReceived) {
    check(mosquitto_loop_read(client_, 1));
  }
  while (connected() && !reconnected_ && !waiting_.empty()) {
    unsent_ += publish(waiting_.front().data(), waiting_.front().size()) ? 0 : 1;
    waiting_.pop_front();
  }
  if (mosquitto_want_write(client_)) {
    check(mosquitto_loop_write(client_, 1));
  }
  if (now >= next_upkeep_) {
    next_upkeep_ = now + kBetweenUpkeep;
    check(mosquitto_loop_misc(client_));
  }
}

int MqttCarrier::descriptor() const {
  return client_ == nullptr || is_connecting() ? -1 : mosquitto_socket(client_);
}

bool MqttCarrier::wants_to_write() const {
  return descriptor() >= 0 && mosquitto_want_write(client_);
}

bool MqttCarrier::take(std::vector<std::uint8_t>& message) {
  if (received_.empty()) {
    return false;
  }
  message = std::move(received_.front());
  received_.pop_front();
  return true;
}

bool MqttCarrier::take_reconnected() {
  return std::exchange(reconnected_, false);
}

void MqttCarrier::on_connect(mosquitto* client, void* self, int reason, int,
                             const mosquitto_property*) {
  auto& carrier = *static_cast<MqttCarrier*>(self);
  carrier.is_answered_ = true;
  if (reason != MQTT_RC_SUCCESS) {
    const bool is_login =
        reason == MQTT_RC_BAD_USERNAME_OR_PASSWORD || reason == MQTT_RC_NOT_AUTHORIZED;
    carrier.trouble_ =
        is_login ? "refuses the user name \"" + carrier.user_ + "\" or the password"
                 : std::string("refuses the connection: ") + mosquitto_reason_string(reason);
    return;
  }
  // Subscribes before the hello is sent, so that an answer to it is received.
  mosquitto_subscribe_v5(client, nullptr, carrier.down_topic_.c_str(), 1,
                         MQTT_SUB_OPT_SEND_RETAIN_NEVER, nullptr);
  carrier.trouble_.clear();
  carrier.connected_ = true;
  carrier.reconnected_ = carrier.was_connected_;
  carrier.was_connected_ = true;
}

void MqttCarrier::on_publish(mosquitto*, void* self, int, int reason, const mosquitto_property*) {
  if (reason >= MQTT_RC_UNSPECIFIED) {
    ++static_cast<MqttCarrier*>(self)->unsent_;
  }
}

void MqttCarrier::on_message(mosquitto*, void* self, const mosquitto_message* message,
                             const mosquitto_property*) {
  if (message->payloadlen == 0) {
    return;
  }
  const auto* bytes = static_cast<const std::uint8_t*>(message->payload);
  static_cast<MqttCarrier*>(self)->received_.emplace_back(bytes, bytes + message->payloadlen);
}

}  // namespace gs::host
