// A flash of two slots with given contents; the remaining cells are erased.
#pragma once

#include <settings_storage/settings_storage.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gsbench::fuzz {

class FlashCells final : public gs::settings_storage::Flash {
 public:
  explicit FlashCells(std::vector<std::uint8_t> bytes = {}) : bytes_(std::move(bytes)) {
    bytes_.resize(gs::settings_storage::kSlots * kSlotBytes, 0xFF);
  }

  bool erase(int slot) override {
    for (std::size_t i = 0; i < kSlotBytes; ++i) {
      bytes_[place(slot, i)] = 0xFF;
    }
    return true;
  }
  bool program(int slot, std::size_t offset, std::uint32_t word) override {
    if (read(slot, offset) != 0xFFFFFFFFU) {
      misused_ = true;
    }
    if (misused_) {
      return false;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      bytes_[place(slot, offset) + i] = static_cast<std::uint8_t>(word >> (8 * i));
    }
    return true;
  }
  std::uint32_t read(int slot, std::size_t offset) const override {
    if (offset % 4 != 0 || offset + 4 > kSlotBytes) {
      misused_ = true;
      return 0;
    }
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      word |= std::uint32_t{bytes_[place(slot, offset) + i]} << (8 * i);
    }
    return word;
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  // True after an access to a misaligned word or one outside its slot, or after programming a word
  // twice.
  bool misused() const { return misused_; }

 private:
  static constexpr std::size_t kSlotBytes = gs::settings_storage::kSlotBytes;
  static std::size_t place(int slot, std::size_t offset) {
    return static_cast<std::size_t>(slot) * kSlotBytes + offset;
  }

  std::vector<std::uint8_t> bytes_;
  mutable bool misused_ = false;
};

}  // namespace gsbench::fuzz
