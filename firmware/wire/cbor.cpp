#include <wire/cbor.hpp>

namespace gs::wire::cbor {
namespace {

// Major types.
enum : std::uint8_t { kUnsigned, kNegative, kBytes, kText, kArray, kMap, kTag, kSimple };
constexpr std::uint8_t kFalse = 20;
constexpr std::uint8_t kTrue = 21;
constexpr std::uint8_t kSimpleByte = 24;  // the simple value is in the byte that follows
constexpr std::uint8_t kFirstLongSimple = 32;
constexpr std::uint8_t kSingle = 26;

}  // namespace

void Writer::put(std::uint8_t byte) {
  if (size_ >= capacity_) {
    ok_ = false;
    return;
  }
  out_[size_++] = byte;
}

void Writer::head(std::uint8_t major, std::uint64_t value) {
  const auto type = static_cast<std::uint8_t>(major << 5);
  if (value < 24) {
    put(static_cast<std::uint8_t>(type | value));
    return;
  }
  int bytes = 8;
  std::uint8_t info = 27;
  if (value <= 0xFFu) {
    bytes = 1;
    info = 24;
  } else if (value <= 0xFFFFu) {
    bytes = 2;
    info = 25;
  } else if (value <= 0xFFFFFFFFu) {
    bytes = 4;
    info = 26;
  }
  put(static_cast<std::uint8_t>(type | info));
  for (int byte = bytes - 1; byte >= 0; --byte) {
    put(static_cast<std::uint8_t>(value >> (8 * byte)));
  }
}

void Writer::integer(std::int64_t value) {
  if (value >= 0) {
    head(kUnsigned, static_cast<std::uint64_t>(value));
  } else {
    head(kNegative, static_cast<std::uint64_t>(-(value + 1)));
  }
}

void Writer::single(float value) {
  std::uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  if (value != value) {
    bits = 0x7FC00000u;
  }
  put(static_cast<std::uint8_t>((kSimple << 5) | kSingle));
  for (int shift = 24; shift >= 0; shift -= 8) {
    put(static_cast<std::uint8_t>(bits >> shift));
  }
}

void Writer::text(const char* text, std::size_t length) {
  head(kText, length);
  for (std::size_t i = 0; i < length; ++i) {
    put(static_cast<std::uint8_t>(text[i]));
  }
}

Reader::Head Reader::peek() const {
  if (at_ == end_) {
    return {};
  }
  Head head{static_cast<std::uint8_t>(*at_ >> 5), static_cast<std::uint8_t>(*at_ & 0x1Fu), 0,
            at_ + 1};
  head.value = head.info;
  if (head.info >= 24) {
    if (head.info > 27) {
      return {};  // indefinite lengths and reserved values
    }
    const std::size_t bytes = std::size_t{1} << (head.info - 24);
    if (static_cast<std::size_t>(end_ - head.end) < bytes) {
      return {};
    }
    head.value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      head.value = (head.value << 8) | *head.end++;
    }
    if (head.major == kSimple && head.info == kSimpleByte && head.value < kFirstLongSimple) {
      return {};  // RFC 8949, §3.3 requires the one-byte form
    }
  }
  return head;
}

bool Reader::pass(const Head& head) {
  at_ = head.end;
  return true;
}

bool Reader::container(std::uint8_t wanted, std::size_t items_each, std::size_t& count) {
  const Head head = peek();
  // Each item takes at least one byte.
  if (head.major != wanted || head.value > static_cast<std::size_t>(end_ - head.end) / items_each) {
    return false;
  }
  count = static_cast<std::size_t>(head.value);
  return pass(head);
}

bool Reader::unsigned_integer(std::uint64_t& value) {
  const Head head = peek();
  if (head.major != kUnsigned) {
    return false;
  }
  value = head.value;
  return pass(head);
}

bool Reader::integer(std::int64_t& value) {
  const Head head = peek();
  if (head.major > kNegative || (head.value >> 63) != 0) {
    return false;
  }
  const auto magnitude = static_cast<std::int64_t>(head.value);
  value = head.major == kNegative ? -magnitude - 1 : magnitude;
  return pass(head);
}

bool Reader::single(float& value) {
  const Head head = peek();
  if (head.major != kSimple || head.info != kSingle) {
    return false;
  }
  const auto bits = static_cast<std::uint32_t>(head.value);
  __builtin_memcpy(&value, &bits, sizeof value);
  return pass(head);
}

bool Reader::boolean(bool& value) {
  const Head head = peek();
  if (head.major != kSimple || (head.info != kFalse && head.info != kTrue)) {
    return false;
  }
  value = head.info == kTrue;
  return pass(head);
}

bool Reader::text(char* out, std::size_t most) {
  const Head head = peek();
  if (head.major != kText || head.value > most ||
      head.value > static_cast<std::size_t>(end_ - head.end)) {
    return false;
  }
  for (std::size_t i = 0; i < head.value; ++i) {
    const std::uint8_t character = head.end[i];
    if (character < ' ' || character > '~') {
      return false;
    }
    out[i] = static_cast<char>(character);
  }
  out[head.value] = '\0';
  at_ = head.end + head.value;
  return true;
}

bool Reader::skip() {
  Reader next = *this;
  // Items still to be skipped. Those inside a container are added, so that no recursion is needed.
  std::uint64_t items = 1;
  while (items > 0) {
    const Head head = next.peek();
    if (head.major == kNone) {
      return false;
    }
    next.pass(head);
    --items;
    const bool is_string = head.major == kBytes || head.major == kText;
    const bool is_container = head.major == kArray || head.major == kMap;
    if ((is_string || is_container) && head.value > next.left()) {
      return false;
    }
    if (is_string) {
      next.at_ += head.value;
    } else if (is_container) {
      items += head.major == kMap ? 2 * head.value : head.value;
    } else if (head.major == kTag) {
      ++items;
    }
    if (items > next.left()) {
      return false;
    }
  }
  *this = next;
  return true;
}

}  // namespace gs::wire::cbor
