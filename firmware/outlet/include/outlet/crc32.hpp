// CRC-32 of IEEE 802.3: reflected, polynomial 0x04C11DB7; check value for "123456789": 0xCBF43926.
// Computed bit by bit, without a table, to save memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::outlet {

class Crc32 {
 public:
  void add(std::uint8_t byte) {
    state_ ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      state_ = (state_ >> 1) ^ ((state_ & 1u) != 0 ? 0xEDB88320u : 0u);
    }
  }
  void add(const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      add(bytes[i]);
    }
  }
  // Least significant byte first.
  void add_word(std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) {
      add(static_cast<std::uint8_t>(word >> shift));
    }
  }
  void add_word(float value) {
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, &value, sizeof bits);
    add_word(bits);
  }
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFu;
};

}  // namespace gs::outlet
