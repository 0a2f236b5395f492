// An outlet's MQTT 5 client. Topics, one CBOR message per payload:
//   gs/<id>/hello  the outlet's hello, retained while the outlet is connected. When the outlet
//                  disconnects, the last will, an empty message, deletes it.
//   gs/<id>/up     all other messages from the outlet
//   gs/<id>/down   messages to the outlet
// Measurements have QoS 0, everything else QoS 1. A session ends with its connection, so that an
// outlet does not execute old commands after it reconnects.
//
// No call blocks: the outlet's loop waits on descriptor(), among others, and calls serve(). An
// attempt to connect has a thread of its own, and there is no descriptor meanwhile.
#pragma once

#include "address.hpp"
#include "attempt.hpp"
#include "tls.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <app/endpoint.hpp>

struct mosquitto;
struct mosquitto_message;
struct mqtt5__property;

namespace gs::host {

struct MqttOptions {
  std::string url;      // mqtts://host:port with TLS, mqtt://host:port without
  std::string ca_file;  // for TLS: certificate of the broker's CA
  std::string user;
  std::string password;
  std::string id;
  std::uint32_t instance = 0;  // part of the client id: two outlets with one id can both connect
};

class MqttCarrier final : public app::Carrier {
 public:
  MqttCarrier() = default;
  // Disconnects; the broker then publishes the last will. Waits for the end of an attempt to
  // connect, and may so wait for a name server.
  ~MqttCarrier();
  MqttCarrier(const MqttCarrier&) = delete;
  MqttCarrier& operator=(const MqttCarrier&) = delete;

  // Returns false with the reason in `why` if the options are invalid, or the CA file cannot be
  // read. serve() connects, and keeps trying.
  bool start(const MqttOptions& options, std::string& why);

  // Returns false for a measurement while there is no connection, and for any message if the queue
  // is full. Once there was a connection, a hello is not queued: the next one has its own. A
  // message of which the broker says later that it does not take it is counted instead.
  bool send(const std::uint8_t* message, std::size_t size) override;

  // Receives messages, sends queued messages, keeps the connection alive, and reconnects after a
  // loss of the connection. Call it at least ten times a second, and whenever the descriptor is
  // ready.
  void serve();
  int descriptor() const;  // -1: no socket now
  bool wants_to_write() const;

  // Takes the next message to the outlet. Returns false if there is none. Empty payloads are no
  // messages.
  bool take(std::vector<std::uint8_t>& message);
  std::size_t waiting() const { return received_.size(); }  // messages that it could take now
  // True once after each reconnection. The outlet must then send its hello again, because the
  // broker may no longer have it. Queued messages wait for this call, so that the hello is first.
  bool take_reconnected();

  bool is_connecting() const { return attempt_.running(); }
  bool connected() const { return connected_ && descriptor() >= 0; }
  // Why the last connection failed or ended, as the end of a sentence about the broker: "cannot be
  // found: …". Empty: it did not.
  const std::string& trouble() const { return trouble_; }
  // Messages since the last call that send() accepted, and that the broker rejected or that could
  // not be sent after all.
  std::uint32_t take_unsent() { return std::exchange(unsent_, 0); }

 private:
  static constexpr auto kBetweenAttempts = std::chrono::milliseconds(500);

  struct Outcome {
    int error = 0;
    int number = 0;  // errno
  };

  static void on_connect(mosquitto*, void* self, int reason, int, const mqtt5__property*);
  static void on_disconnect(mosquitto*, void* self, int reason, const mqtt5__property*);
  static void on_publish(mosquitto*, void* self, int, int reason, const mqtt5__property*);
  static void on_message(mosquitto*, void* self, const mosquitto_message* message,
                         const mqtt5__property*);
  static void on_log(mosquitto*, void* self, int level, const char* text);
  void connect();
  bool publish(const std::uint8_t* message, std::size_t size);
  void check(int error);
  std::string trouble_of(int error, int number) const;  // `number`: errno

  Tls tls_;
  mosquitto* client_ = nullptr;
  Address address_;
  bool is_tls_ = false;
  std::string user_;
  std::string hello_topic_;
  std::string up_topic_;
  std::string down_topic_;
  std::deque<std::vector<std::uint8_t>> received_;
  std::chrono::steady_clock::time_point next_attempt_;
  std::chrono::steady_clock::time_point next_upkeep_;
  std::deque<std::vector<std::uint8_t>> waiting_;  // queued while there is no connection
  std::uint32_t unsent_ = 0;
  std::string trouble_;
  std::string logged_;        // the library's last error message during this attempt to connect
  bool is_answered_ = false;  // this attempt, by the broker
  bool connected_ = false;
  bool was_connected_ = false;
  bool reconnected_ = false;
  std::chrono::steady_clock::time_point interrupt_;
  Attempt<Outcome> attempt_;  // has client_, tls_ and logged_ while it runs
};

}  // namespace gs::host
