#include <algorithm>
#include <random>
#include <utility>

#include <link/outlet_stream.hpp>
#include <link/unreadable.hpp>

namespace gsbench::link {

using gs::wire::Decoded;
using gs::wire::DownlinkKind;
using gs::wire::Sequence;
using gs::wire::UplinkKind;

namespace {

constexpr std::size_t kMostEarlierStarts = 64;

bool is_hello(const gs::wire::Uplink& message) {
  return message.kind == UplinkKind::kHello;
}

}  // namespace

std::uint32_t new_session() {
  std::random_device device;
  std::uint32_t session = gs::wire::kNoSession;
  while (session == gs::wire::kNoSession) {
    session = device();
  }
  return session;
}

std::optional<gs::wire::Uplink> OutletStream::take(const std::uint8_t* bytes, std::size_t size) {
  gs::wire::Uplink message;
  std::uint32_t sequence = 0;
  const Decoded decoded = gs::wire::decode(bytes, size, message, sequence);
  if (decoded == Decoded::kMalformed) {
    unreadable_ = unreadable_fault(bytes, size);
    note(unreadable_);
    return std::nullopt;
  }
  sequence_ = sequence;
  const bool known = decoded == Decoded::kOk;
  if (known && is_hello(message)) {
    unreadable_.clear();
  }
  // Of another version, the start number is unknown.
  if (known && is_hello(message) && message.hello.protocol_version != gs::wire::kProtocolVersion) {
    return message;
  }
  if (!take_start(message) || !take_number(message, sequence)) {
    return std::nullopt;
  }
  last_sample_ = message.sample;
  if (!known) {
    note("sent a message of an unknown kind");
    return std::nullopt;
  }
  look_at_session(message);
  return message;
}

// False if the message is not to be taken.
bool OutletStream::take_start(const gs::wire::Uplink& message) {
  const std::uint32_t number = message.start_number;
  if (start_ == number) {
    return true;
  }
  // Another unit has other starts: its first is no restart.
  const bool is_other = is_hello(message) && !id_.empty() &&
                        (id_ != message.hello.id || instance_ != message.hello.instance);
  if (is_other) {
    earlier_starts_.clear();
    start_.reset();
  }
  if (std::count(earlier_starts_.begin(), earlier_starts_.end(), number) > 0) {
    return false;
  }
  if (delivery_ == Delivery::kByCable && !is_hello(message)) {
    want_identify(number);
    open_ = false;
    return false;
  }
  wants_identify_ = wants_identify_ || !is_hello(message);
  begin_start(number);
  return true;
}

// On a cable, the link repeats it until the outlet has answered.
void OutletStream::want_identify(std::uint32_t start) {
  wants_identify_ =
      wants_identify_ || delivery_ == Delivery::kByBroker || identified_start_ != start;
  identified_start_ = start;
}

void OutletStream::begin_start(std::uint32_t number) {
  if (start_) {
    note("restarted after its sample " + std::to_string(last_sample_));
    earlier_starts_.push_back(*start_);
    if (earlier_starts_.size() > kMostEarlierStarts) {
      earlier_starts_.erase(earlier_starts_.begin());
    }
  }
  start_ = number;
  open_ = false;
  hellos_.restart();
  others_.restart();
}

bool OutletStream::take_number(const gs::wire::Uplink& message, std::uint32_t sequence) {
  Sequence& count = is_hello(message) ? hellos_ : others_;
  switch (count.take(sequence)) {
    case Sequence::Order::kDuplicate:
      return false;
    case Sequence::Order::kGap:
      if (!is_hello(message)) {
        note(std::to_string(count.missed()) + " of its messages were lost before its sample " +
             std::to_string(message.sample));
      }
      return true;
    case Sequence::Order::kNext:
      return true;
  }
  return true;
}

void OutletStream::look_at_session(const gs::wire::Uplink& message) {
  if (is_hello(message)) {
    id_ = message.hello.id;
    instance_ = message.hello.instance;
    // Over a broker, an outlet drops messages until it is connected.
    if (delivery_ == Delivery::kByCable) {
      others_.expect(message.hello.next_number);
    }
    open_ = open_ || message.hello.session == session_;
    if (open_) {
      wants_identify_ = false;
    } else {
      want_identify(message.start_number);
    }
  } else if (message.kind == UplinkKind::kError &&
             message.error.code == gs::wire::ErrorCode::kUnknownSession &&
             message.error.detail == session_) {
    note("did not take a message: it did not know the bench's session");
    open_ = false;
    wants_identify_ = true;
  }
}

std::vector<std::uint8_t> OutletStream::encode(gs::wire::Downlink message) {
  message.session = session_;
  if (message.kind == DownlinkKind::kCommand) {
    message.start_number = start_.value_or(0);
  }
  std::vector<std::uint8_t> bytes(gs::wire::kLongestMessage);
  bytes.resize(gs::wire::encode(message, sent_++, bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace gsbench::link
