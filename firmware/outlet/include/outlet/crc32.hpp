// CRC-32 of IEEE 802.3: reflected, polynomial 0x04C11DB7; check value for "123456789": 0xCBF43926.
// Computed by half bytes, with a small table.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::outlet {

class Crc32 {
 public:
  void add(std::uint8_t byte) {
    state_ ^= byte;
    state_ = (state_ >> 4) ^ kOfHalfByte[state_ & 0xFu];
    state_ = (state_ >> 4) ^ kOfHalfByte[state_ & 0xFu];
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
  static constexpr std::uint32_t kOfHalfByte[16] = {
      0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
      0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
      0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
  std::uint32_t state_ = 0xFFFFFFFFu;
};

}  // namespace gs::outlet
