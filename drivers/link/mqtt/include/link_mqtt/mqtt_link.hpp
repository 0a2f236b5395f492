// Outlets behind an MQTT 5 broker, all over one connection. The topics are those of the outlets'
// own end: gs/<id>/hello (retained for as long as the outlet is there), gs/<id>/up, gs/<id>/down.
//
// The broker must let as many messages to the bench be under way at once as MQTT can number
// (Mosquitto: max_inflight_messages 65535): one that holds an acknowledged message back while it
// lets later measurements pass changes their order, and the one held back then counts as lost.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

struct MqttOptions {
  std::string url;      // mqtts://host:port with TLS, mqtt://host:port without
  std::string ca_file;  // for TLS: who may vouch for the broker
  std::string user;
  std::string password;
  std::vector<std::string> outlets;  // their ids, to look for no others; none: all that are found
};

class MqttLink final : public Link {
 public:
  explicit MqttLink(MqttOptions options);
  ~MqttLink() override;

  // Blocks until the broker has answered, some ten seconds at most.
  [[nodiscard]] drivers::Status open() override;
  // What the broker did not take or had nobody to give to comes back as a fault. While the broker
  // is away, messages wait for it.
  [[nodiscard]] drivers::Status send(const std::string& id,
                                     const gs::wire::Downlink& message) override;
  // A broker that is lost is a fault of each outlet's, once; the link connects again by itself.
  [[nodiscard]] drivers::Status poll(Happenings& happenings) override;
  std::vector<Fault> missing() override;
  void close() noexcept override;

 private:
  class Opened;

  void send(std::size_t outlet, const gs::wire::Downlink& message);

  MqttOptions options_;
  std::unique_ptr<Opened> opened_;
};

}  // namespace gsbench::link
