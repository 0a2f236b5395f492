#include <app/endpoint.hpp>

namespace gs::app {

using wire::Decoded;
using wire::ErrorCode;

void MessageEndpoint::put(const wire::Uplink& message) {
  const std::size_t size = wire::encode(message, sent_, bytes_, sizeof bytes_);
  // A message that the carrier refuses uses up a number: the other side sees the gap.
  ++sent_;
  if (!carrier_.send(bytes_, size)) {
    app_.note_unsent();
  }
}

void MessageEndpoint::receive(const std::uint8_t* bytes, std::size_t size) {
  wire::Downlink message;
  std::uint32_t sequence = 0;
  switch (wire::decode(bytes, size, message, sequence)) {
    case Decoded::kMalformed:
      return app_.note(ErrorCode::kMalformed, *this);
    case Decoded::kUnknownKind:
      return app_.note(ErrorCode::kUnknownKind, *this);
    case Decoded::kOk:
      break;
  }
  // A peer that sends identify has restarted its numbering.
  if (message.kind == wire::DownlinkKind::kIdentify) {
    received_.restart();
  }
  if (received_.take(sequence) != wire::Sequence::Order::kDuplicate) {
    app_.receive(message, *this);
  }
}

bool SerialEndpoint::Framer::send(const std::uint8_t* bytes, std::size_t count) {
  const std::size_t size = wire::frame(bytes, count, bytes_, sizeof bytes_);
  return size > 0 && carrier_.send(bytes_, size);
}

void SerialEndpoint::receive(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    switch (reader_.take(bytes[i])) {
      case wire::FrameReader::Taken::kNothing:
        break;
      case wire::FrameReader::Taken::kBadFrame:
        app_.note(ErrorCode::kBadFrame, *this);
        break;
      case wire::FrameReader::Taken::kMessage:
        whole_.receive(reader_.message(), reader_.size());
        break;
    }
  }
}

}  // namespace gs::app
