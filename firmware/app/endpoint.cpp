#include <app/endpoint.hpp>

namespace gs::app {

using wire::Decoded;
using wire::ErrorCode;

void MessageEndpoint::put(const wire::Uplink& message) {
  std::size_t size = 0;
  // A message that the carrier refuses uses up a number: the other side sees the gap.
  if (message.kind == wire::UplinkKind::kHello) {
    wire::Uplink hello = message;
    hello.hello.next_number = others_sent_;
    size = wire::encode(hello, hellos_sent_++, bytes_, sizeof bytes_);
  } else {
    size = wire::encode(message, others_sent_++, bytes_, sizeof bytes_);
  }
  if (!carrier_.send(bytes_, size)) {
    app_.note_unsent();
  }
}

void MessageEndpoint::receive(const std::uint8_t* bytes, std::size_t size) {
  wire::Downlink message;
  std::uint32_t sequence = 0;
  const Decoded decoded = wire::decode(bytes, size, message, sequence);
  if (decoded == Decoded::kMalformed) {
    return app_.note(ErrorCode::kMalformed, *this);
  }
  const bool known = decoded == Decoded::kOk;
  Session* session = sessions_.find(message.session);
  if (session == nullptr && known && message.kind == wire::DownlinkKind::kIdentify) {
    session = &sessions_.begin(message.session);
  }
  if (session == nullptr) {
    return app_.refuse(ErrorCode::kUnknownSession, message.session, *this);
  }
  if (session->received.take(sequence) == wire::Sequence::Order::kDuplicate) {
    return app_.note_dropped();
  }
  session = &sessions_.use(*session);
  if (!known) {
    return app_.note(ErrorCode::kUnknownKind, *this);
  }
  if (message.kind == wire::DownlinkKind::kCommand) {
    return take_command(message, *session);
  }
  app_.receive(message, *this);
}

// A centre that misses the answer sends the same request again, in a new message.
void MessageEndpoint::take_command(const wire::Downlink& command, Session& session) {
  if (command.start_number != app_.start_number()) {
    return app_.refuse(ErrorCode::kOtherStart, command.request, *this);
  }
  if (command.request <= session.newest_request) {
    return app_.answer_command(command, *this);
  }
  session.newest_request = command.request;
  app_.receive(command, *this);
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
