// Why an outlet is not connected to its broker, in words.
#include "mqtt_carrier.hpp"
#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <netdb.h>

#include <cerrno>
#include <cstring>

namespace gs::host {
namespace {

// OpenSSL's words in libmosquitto's log: "OpenSSL Error[0]: error:0A00010B:SSL routines::wrong
// version number".
std::string reason_in(const std::string& logged) {
  const std::size_t mark = logged.rfind("::");
  return mark == std::string::npos ? logged : logged.substr(mark + 2);
}

}  // namespace

std::string MqttCarrier::trouble_of(int error, int number) const {
  if (!tls_.refusal().empty()) {
    return "has a certificate that is refused: " + tls_.refusal();
  }
  const bool is_end =
      error == MOSQ_ERR_CONN_LOST ||
      (error == MOSQ_ERR_ERRNO && (number == EPROTO || number == ECONNRESET || number == EPIPE));
  if (is_tls_ && !is_answered_ && is_end) {
    // An alert of TLS is lost if the connection is reset before it is read.
    return logged_.find("alert") != std::string::npos
               ? "ends the TLS connection: " + reason_in(logged_)
               : "ended the TLS connection without an answer; it may require a certificate of its "
                 "clients, which gs-outlet does not have";
  }
  switch (error) {
    case MOSQ_ERR_EAI:
      return std::string("cannot be found: ") + gai_strerror(number);
    case MOSQ_ERR_ERRNO:
      return std::string(is_answered_ ? "has lost the connection: " : "cannot be connected to: ") +
             std::strerror(number);
    case MOSQ_ERR_TLS:
      return "fails the TLS handshake: " + reason_in(logged_) +
             (logged_.find("alert") == std::string::npos ? "; there may be no TLS on this port"
                                                         : "");
    case MOSQ_ERR_KEEPALIVE:
      return is_answered_ ? "does not answer any more"
             : is_tls_    ? "does not answer; there may be no TLS on this port"
                          : "does not answer";
    case MOSQ_ERR_CONN_LOST:
      return is_answered_ ? "ended the connection: it has stopped, or another outlet with the same "
                            "id and instance has connected"
                          : "ended the connection without an answer; it may speak TLS on this "
                            "port: mqtts://";
    case MQTT_RC_SESSION_TAKEN_OVER:
      return "ended the connection: another outlet with the same id and instance has connected";
    default:
      return error >= MQTT_RC_UNSPECIFIED
                 ? std::string("ended the connection: ") + mosquitto_reason_string(error)
                 : std::string("cannot be used: ") + mosquitto_strerror(error);
  }
}

void MqttCarrier::check(int error) {
  if (error != MOSQ_ERR_SUCCESS && trouble_.empty()) {
    trouble_ = trouble_of(error, errno);
  }
}

void MqttCarrier::on_disconnect(mosquitto*, void* self, int reason, const mosquitto_property*) {
  auto& carrier = *static_cast<MqttCarrier*>(self);
  carrier.connected_ = false;
  carrier.next_attempt_ = std::chrono::steady_clock::now() + kBetweenAttempts;
  if (carrier.trouble_.empty()) {
    carrier.trouble_ = carrier.trouble_of(reason, errno);
  }
}

void MqttCarrier::on_log(mosquitto*, void* self, int level, const char* text) {
  if (level == MOSQ_LOG_ERR) {
    static_cast<MqttCarrier*>(self)->logged_ = text;
  }
}

}  // namespace gs::host
