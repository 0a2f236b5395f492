// An outlet's own end of MQTT 5: its messages to the broker, and what the broker has for it.
//
// On the broker, gs/<id>/hello holds the outlet's hello for as long as it is there (retained; the
// last will empties it), gs/<id>/up carries everything else it says, gs/<id>/down what is said to
// it. One CBOR message each. Measurements go at most once, all else at least once. A session ends
// with its connection, so that an outlet that comes back obeys nothing that was said meanwhile.
//
// Nothing here blocks or runs by itself: the outlet's one loop waits on descriptor() beside
// whatever else it waits for, and calls serve().
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <app/endpoint.hpp>

struct mosquitto;
struct mosquitto_message;
struct mqtt5__property;

namespace gs::host {

struct MqttOptions {
  std::string url;      // mqtts://host:port with TLS, mqtt://host:port without
  std::string ca_file;  // for TLS: who may vouch for the broker
  std::string user;
  std::string password;
  std::string id;
  std::uint32_t instance = 0;  // two outlets with one id both stay connected
};

class MqttCarrier final : public app::Carrier {
 public:
  MqttCarrier() = default;
  ~MqttCarrier();  // leaves the broker, which empties the hello
  MqttCarrier(const MqttCarrier&) = delete;
  MqttCarrier& operator=(const MqttCarrier&) = delete;

  // False, with the reason, where the options make no sense. A broker that is not there is tried
  // again and again.
  bool start(const MqttOptions& options, std::string& why);

  // False for a measurement without a connection, and for anything where too much waits already.
  bool send(const std::uint8_t* message, std::size_t size) override;

  // Receives, sends what waits, keeps the connection alive and makes it again where it is lost. At
  // least ten times a second, and whenever the descriptor is ready.
  void serve();
  int descriptor() const;  // -1: none now
  bool wants_to_write() const;

  // The next message to the outlet.
  bool take(std::vector<std::uint8_t>& message);
  // True once after each connection but the first: the broker may have forgotten the hello.
  bool take_reconnected();

  bool connected() const { return connected_ && descriptor() >= 0; }
  const std::string& trouble() const { return trouble_; }  // of the last connection that failed
  std::uint64_t refused() const { return refused_; }       // messages the broker has no leave for

 private:
  static void on_connect(mosquitto*, void* self, int reason, int, const mqtt5__property*);
  static void on_disconnect(mosquitto*, void* self, int reason, const mqtt5__property*);
  static void on_publish(mosquitto*, void* self, int, int reason, const mqtt5__property*);
  static void on_message(mosquitto*, void* self, const mosquitto_message* message,
                         const mqtt5__property*);
  void connect();
  bool publish(const std::uint8_t* message, std::size_t size);
  void check(int error);

  mosquitto* client_ = nullptr;
  std::string host_;
  int port_ = 0;
  std::string hello_topic_;
  std::string up_topic_;
  std::string down_topic_;
  std::deque<std::vector<std::uint8_t>> received_;
  std::chrono::steady_clock::time_point next_attempt_;
  std::chrono::steady_clock::time_point next_upkeep_;
  std::deque<std::vector<std::uint8_t>> waiting_;  // taken without a connection
  std::uint64_t refused_ = 0;
  std::string trouble_;
  bool connected_ = false;
  bool was_connected_ = false;
  bool reconnected_ = false;
};

}  // namespace gs::host
