#include "mqtt_line.hpp"

namespace gs::host {

bool MqttLine::send(const std::uint8_t* bytes, std::size_t count) {
  bool sent = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (reader_.take(bytes[i]) == wire::FrameReader::Taken::kMessage) {
      sent = carrier_.send(reader_.message(), reader_.size()) && sent;
    }
  }
  return sent;
}

void MqttLine::serve() {
  carrier_.serve();
  if (carrier_.trouble() != trouble_) {
    trouble_ = carrier_.trouble();
    if (!trouble_.empty()) {
      report("not connected: the broker " + url_ + ' ' + trouble_);
    }
  }
  if (carrier_.connected() && !connected_) {
    report((was_connected_ ? "connected again to the broker " : "connected to the broker ") + url_);
    was_connected_ = true;
  }
  connected_ = carrier_.connected();
  std::vector<std::uint8_t> message;
  if (received_.empty() && carrier_.take(message)) {  // one at a time: the carrier bounds its queue
    std::uint8_t framed[wire::kLongestFrame];
    // A message that is too long for a frame is malformed. Another malformed message in its place
    // makes the outlet count and report it.
    if (message.size() > wire::kLongestMessage) {
      message = {0xFF};
    }
    const std::size_t size = wire::frame(message.data(), message.size(), framed, sizeof framed);
    received_.insert(received_.end(), framed, framed + size);
  }
}

}  // namespace gs::host
