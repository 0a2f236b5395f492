// Bytes between an interrupt and the loop: one side puts, the other takes. On one core, volatile
// keeps the order: a byte is in before it counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::superloop {

template <std::size_t kBytes>
class ByteRing {
  static_assert((kBytes & (kBytes - 1)) == 0, "the counters wrap at powers of two");

 public:
  std::size_t used() const { return put_ - taken_; }
  std::size_t room() const { return kBytes - used(); }

  // False where it is full.
  bool put(std::uint8_t byte) {
    if (room() == 0) {
      return false;
    }
    bytes_[put_ % kBytes] = byte;
    put_ = put_ + 1;
    return true;
  }

  // All of them or none.
  bool put(const std::uint8_t* bytes, std::size_t count) {
    if (room() < count) {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      put(bytes[i]);
    }
    return true;
  }

  bool take(std::uint8_t& byte) {
    if (used() == 0) {
      return false;
    }
    byte = bytes_[taken_ % kBytes];
    taken_ = taken_ + 1;
    return true;
  }

 private:
  volatile std::uint32_t put_ = 0;
  volatile std::uint32_t taken_ = 0;
  volatile std::uint8_t bytes_[kBytes] = {};
};

}  // namespace gs::superloop
