// Adapts MQTT to a line: a broker carries whole messages, the outlet's loop uses frames. Each frame
// is one message, in both directions.
#pragma once

#include "line.hpp"
#include "mqtt_carrier.hpp"

#include <string>

#include <wire/frame.hpp>

namespace gs::host {

class MqttLine final : public Line {
 public:
  bool start(const MqttOptions& options, std::string& why) {
    url_ = options.url;
    return carrier_.start(options, why);
  }

  bool send(const std::uint8_t* bytes, std::size_t count) override;
  // Reports each connection, and once why there is none.
  void serve() override;
  int descriptor() const override { return carrier_.descriptor(); }
  bool wants_to_write() const override { return carrier_.wants_to_write(); }
  bool is_connecting() const override { return carrier_.is_connecting(); }
  bool take_reconnected() override { return carrier_.take_reconnected(); }
  std::uint32_t take_unsent() override { return carrier_.take_unsent(); }

 private:
  MqttCarrier carrier_;
  wire::FrameReader reader_;
  std::string url_;
  std::string trouble_;  // reported last
  bool connected_ = false;
  bool was_connected_ = false;
};

}  // namespace gs::host
