#include <utility>

#include <link/outlet_stream.hpp>

namespace gsbench::link {

using gs::wire::Decoded;
using gs::wire::Sequence;
using gs::wire::UplinkKind;

std::optional<gs::wire::Uplink> OutletStream::take(const std::uint8_t* bytes, std::size_t size) {
  // On a cable, a repeated or swapped message is at most this many numbers back: 1 s of
  // measurements.
  constexpr std::uint32_t kMostRepeated = 64;
  gs::wire::Uplink message;
  std::uint32_t sequence = 0;
  const Decoded decoded = gs::wire::decode(bytes, size, message, sequence);
  if (decoded != Decoded::kOk) {
    note(decoded == Decoded::kUnknownKind ? "sent a message of an unknown kind"
                                          : "sent a message that cannot be read");
    return std::nullopt;
  }
  // At start-up an outlet numbers from 0, and its first message is its hello.
  const bool restarted = message.kind == UplinkKind::kHello && sequence == 0;
  if (restarted) {
    // A broker may deliver a hello twice: the same bytes, with no message in between.
    std::vector<std::uint8_t> hello(bytes, bytes + size);
    if (hello == newest_) {
      return std::nullopt;
    }
    newest_ = std::move(hello);
    if (hello_received_ && (last_sample_ > message.sample || message.sample == 0)) {
      note_restart();
    }
    received_.restart();
  } else {
    newest_.clear();
  }
  bool goes_back = message.kind != UplinkKind::kHello && message.sample < last_sample_;
  switch (received_.take(sequence)) {
    case Sequence::Order::kDuplicate:
      if (delivery_ == Delivery::kByBroker || received_.behind() <= kMostRepeated) {
        return std::nullopt;
      }
      goes_back = true;
      received_.restart();
      received_.take(sequence);
      break;
    case Sequence::Order::kGap:
      // What an outlet sends before it has connected for the first time is lost. That is no fault.
      if (message.kind == UplinkKind::kHello && !reports_received_) {
        break;
      }
      note(std::to_string(received_.missed()) + " of its messages were lost before its sample " +
           std::to_string(message.sample));
      break;
    case Sequence::Order::kNext:
      break;
  }
  if (goes_back) {
    note_restart();
  }
  hello_received_ = hello_received_ || message.kind == UplinkKind::kHello;
  reports_received_ = reports_received_ || message.kind != UplinkKind::kHello;
  last_sample_ = message.sample;
  return message;
}

std::vector<std::uint8_t> OutletStream::encode(const gs::wire::Downlink& message) {
  if (message.kind == gs::wire::DownlinkKind::kIdentify) {
    sent_ = 0;
  }
  std::vector<std::uint8_t> bytes(gs::wire::kLongestMessage);
  bytes.resize(gs::wire::encode(message, sent_++, bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace gsbench::link
