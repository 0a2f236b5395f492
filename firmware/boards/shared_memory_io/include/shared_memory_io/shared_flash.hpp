// An emulated outlet's flash. Its bytes are in the terminals, so they persist when the outlet's
// process ends.
#pragma once

#include <settings_storage/settings_storage.hpp>
#include <shared_memory_io/shared_memory.hpp>

namespace gs::shared_memory_io {

static_assert(settings_storage::kSlots <= static_cast<int>(kFlashSlots));
static_assert(settings_storage::kSlotBytes <= kFlashSlotBytes);

class SharedFlash final : public settings_storage::Flash {
 public:
  explicit SharedFlash(SharedMemory& terminals) : terminals_(terminals) {}

  bool erase(int slot) override {
    for (std::size_t at = 0; at < kFlashSlotBytes; at += sizeof(std::uint32_t)) {
      word(slot, at) = 0xFFFFFFFFu;
    }
    return true;
  }
  // Like flash: bits change from 1 to 0 only.
  bool program(int slot, std::size_t offset, std::uint32_t value) override {
    word(slot, offset) = word(slot, offset) & value;
    return true;
  }
  std::uint32_t read(int slot, std::size_t offset) const override { return word(slot, offset); }

 private:
  volatile std::uint32_t& word(int slot, std::size_t offset) const {
    return *reinterpret_cast<volatile std::uint32_t*>(terminals_.flash[slot] + offset);
  }

  SharedMemory& terminals_;
};

}  // namespace gs::shared_memory_io
