#include <outlet/crc32.hpp>
#include <wire/frame.hpp>

namespace gs::wire {
namespace {

constexpr std::uint8_t kFullGroup = 0xFF;  // 254 bytes without a zero after them

// COBS encoder, byte by byte.
class Stuffer {
 public:
  Stuffer(std::uint8_t* out, std::size_t capacity) : out_(out), capacity_(capacity) {
    raw(0);
    open_group();
  }

  void put(std::uint8_t byte) {
    if (byte == 0) {
      close_group();
      open_group();
      return;
    }
    raw(byte);
    if (++code_ == kFullGroup) {
      close_group();
      open_group();
    }
  }

  std::size_t finish() {
    close_group();
    raw(0);
    return ok_ ? size_ : 0;
  }

 private:
  void raw(std::uint8_t byte) {
    if (size_ >= capacity_) {
      ok_ = false;
      return;
    }
    out_[size_++] = byte;
  }
  void open_group() {
    group_ = size_;
    code_ = 1;
    raw(0);
  }
  void close_group() {
    if (ok_) {
      out_[group_] = code_;
    }
  }

  std::uint8_t* out_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  std::size_t group_ = 0;
  std::uint8_t code_ = 1;
  bool ok_ = true;
};

}  // namespace

std::size_t frame(const std::uint8_t* message, std::size_t size, std::uint8_t* out,
                  std::size_t capacity) {
  if (size == 0 || size > kLongestMessage) {
    return 0;
  }
  outlet::Crc32 crc;
  crc.add(message, size);
  Stuffer stuffer(out, capacity);
  for (std::size_t i = 0; i < size; ++i) {
    stuffer.put(message[i]);
  }
  for (int shift = 0; shift < 32; shift += 8) {
    stuffer.put(static_cast<std::uint8_t>(crc.value() >> shift));
  }
  return stuffer.finish();
}

FrameReader::Taken FrameReader::take(std::uint8_t byte) {
  if (byte == 0) {
    const Taken taken = code_ == 0 ? Taken::kNothing : end_frame();
    code_ = 0;
    to_come_ = 0;
    too_long_ = false;
    return taken;
  }
  if (code_ == 0) {
    size_ = 0;
  }
  if (to_come_ == 0) {
    // A group's zero is part of the data only if another group follows.
    if (code_ != 0 && code_ != kFullGroup) {
      put(0);
    }
    code_ = byte;
    to_come_ = static_cast<std::uint8_t>(byte - 1);
  } else {
    put(byte);
    --to_come_;
  }
  return Taken::kNothing;
}

void FrameReader::put(std::uint8_t byte) {
  if (size_ >= sizeof bytes_) {
    too_long_ = true;
    return;
  }
  bytes_[size_++] = byte;
}

FrameReader::Taken FrameReader::end_frame() {
  if (too_long_ || to_come_ != 0 || size_ <= kCrcLength) {
    return Taken::kBadFrame;
  }
  size_ -= kCrcLength;
  outlet::Crc32 crc;
  crc.add(bytes_, size_);
  std::uint32_t received_crc = 0;
  for (std::size_t i = 0; i < kCrcLength; ++i) {
    received_crc |= static_cast<std::uint32_t>(bytes_[size_ + i]) << (8 * i);
  }
  return crc.value() == received_crc ? Taken::kMessage : Taken::kBadFrame;
}

Sequence::Order Sequence::take(std::uint32_t sequence) {
  const std::uint32_t ahead = sequence - next_;
  const bool is_late = ahead >= 0x80000000u;
  if (started_ && is_late) {
    return Order::kDuplicate;
  }
  missed_ = (started_ || expects_) && !is_late ? ahead : 0;
  started_ = true;
  next_ = sequence + 1;
  return missed_ == 0 ? Order::kNext : Order::kGap;
}

}  // namespace gs::wire
