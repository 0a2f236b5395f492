// Outlets behind an MQTT 5 broker, over one connection. Topics: gs/<id>/hello (retained while the
// outlet is connected), gs/<id>/up, gs/<id>/down.
//
// The broker must allow MQTT's largest number of in-flight messages to the bench (Mosquitto:
// max_inflight_messages 65535). With a lower limit, the broker may hold back QoS 1 messages while
// later measurements pass. The messages held back then count as lost. wire/mqtt.md lists the
// broker's other settings.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

struct MqttOptions {
  std::string url;      // as read_broker_url() takes it
  std::string ca_file;  // for TLS: the CA that signs the broker's certificate, PEM
  std::string user;
  std::string password;
  std::vector<std::string> outlets;  // ids; outlets not in the list are ignored. Empty: all outlets
  // After a lost connection, the broker stores messages for 60 s; close() ends that. If false, the
  // broker keeps nothing for a bench that is not connected.
  bool keeps_session = true;
};

// An error, the reason, if the file cannot be read or holds no certificate in PEM form.
[[nodiscard]] drivers::Status check_ca_file(const std::string& path);

class MqttLink final : public Link {
 public:
  explicit MqttLink(MqttOptions options);
  ~MqttLink() override;

  // Blocks until the broker has accepted connection and subscriptions, about 15 s at most. An error
  // if the broker cannot be reached, fails the TLS check, or refuses the login. Then up to 6 s
  // more: the error states what the resolver, the kernel or OpenSSL reports.
  [[nodiscard]] drivers::Status open() override;
  // A message that the broker refuses, or cannot deliver, becomes a fault of the outlet. Without a
  // connection, up to 10000 messages wait for the broker. Blocks up to 0.5 s if that queue is full.
  [[nodiscard]] drivers::Status send(const std::string& id,
                                     const gs::wire::Downlink& message) override;
  // A lost broker is a fault of each outlet, once for each loss; the link reconnects by itself. So
  // is a subscription that the broker refuses then.
  [[nodiscard]] drivers::Status poll(Happenings& happenings) override;
  std::vector<Fault> missing() override;
  // With a kept session, blocks about 1 s, until the broker has ended it; 5 s at most.
  void close() noexcept override;

 private:
  class Opened;

  void send(std::size_t outlet, const gs::wire::Downlink& message);

  MqttOptions options_;
  std::unique_ptr<Opened> opened_;
};

}  // namespace gsbench::link
