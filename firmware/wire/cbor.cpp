#include <wire/cbor.hpp>

namespace gs::wire::cbor {
namespace {

constexpr std::uint8_t kUnsigned = 0;
constexpr std::uint8_t kNegative = 1;
constexpr std::uint8_t kBytes = 2;
constexpr std::uint8_t kText = 3;
constexpr std::uint8_t kArray = 4;
constexpr std::uint8_t kMap = 5;
constexpr std::uint8_t kTag = 6;
constexpr std::uint8_t kSimple = 7;

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

bool Reader::head(std::uint8_t& major, std::uint8_t& info, std::uint64_t& value) {
  if (at_ == end_) {
    return false;
  }
  major = static_cast<std::uint8_t>(*at_ >> 5);
  info = *at_ & 0x1Fu;
  value = info;
  const std::uint8_t* next = at_ + 1;
  if (info >= 24) {
    if (info > 27) {
      return false;  // indefinite lengths, and what is reserved
    }
    const std::size_t bytes = std::size_t{1} << (info - 24);
    if (static_cast<std::size_t>(end_ - next) < bytes) {
      return false;
    }
    value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value = (value << 8) | *next++;
    }
    if (major == kSimple && info == kSimpleByte && value < kFirstLongSimple) {
      return false;  // has a form of one byte, the only one RFC 8949, §3.3 allows
    }
  }
  at_ = next;
  return true;
}

bool Reader::container(std::uint8_t wanted, std::size_t items_each, std::size_t& count) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  std::uint64_t value = 0;
  // Each item takes a byte at least.
  if (!next.head(major, info, value) || major != wanted || value > next.left() / items_each) {
    return false;
  }
  count = static_cast<std::size_t>(value);
  *this = next;
  return true;
}

bool Reader::array(std::size_t& items) {
  return container(kArray, 1, items);
}

bool Reader::map(std::size_t& pairs) {
  return container(kMap, 2, pairs);
}

bool Reader::unsigned_integer(std::uint64_t& value) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  if (!next.head(major, info, value) || major != kUnsigned) {
    return false;
  }
  *this = next;
  return true;
}

bool Reader::integer(std::int64_t& value) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  std::uint64_t magnitude = 0;
  if (!next.head(major, info, magnitude) || major > kNegative || (magnitude >> 63) != 0) {
    return false;
  }
  value = static_cast<std::int64_t>(magnitude);
  if (major == kNegative) {
    value = -value - 1;
  }
  *this = next;
  return true;
}

bool Reader::single(float& value) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  std::uint64_t wide = 0;
  if (!next.head(major, info, wide) || major != kSimple || info != kSingle) {
    return false;
  }
  const auto bits = static_cast<std::uint32_t>(wide);
  __builtin_memcpy(&value, &bits, sizeof value);
  *this = next;
  return true;
}

bool Reader::boolean(bool& value) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  std::uint64_t wide = 0;
  if (!next.head(major, info, wide) || major != kSimple || (info != kFalse && info != kTrue)) {
    return false;
  }
  value = info == kTrue;
  *this = next;
  return true;
}

bool Reader::text(char* out, std::size_t most) {
  Reader next = *this;
  std::uint8_t major = 0;
  std::uint8_t info = 0;
  std::uint64_t length = 0;
  if (!next.head(major, info, length) || major != kText || length > most || length > next.left()) {
    return false;
  }
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint8_t character = *next.at_++;
    if (character < ' ' || character > '~') {
      return false;
    }
    out[i] = static_cast<char>(character);
  }
  out[length] = '\0';
  *this = next;
  return true;
}

bool Reader::skip() {
  Reader next = *this;
  // Items still to be passed over; what an item holds is added to them, so that nothing nests.
  std::uint64_t items = 1;
  while (items > 0) {
    std::uint8_t major = 0;
    std::uint8_t info = 0;
    std::uint64_t value = 0;
    if (!next.head(major, info, value)) {
      return false;
    }
    --items;
    if (major == kBytes || major == kText) {
      if (value > next.left()) {
        return false;
      }
      next.at_ += value;
    } else if (major == kArray || major == kMap) {
      if (value > next.left()) {
        return false;
      }
      items += major == kMap ? 2 * value : value;
    } else if (major == kTag) {
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
