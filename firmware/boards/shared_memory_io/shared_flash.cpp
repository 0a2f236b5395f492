#include <shared_memory_io/shared_flash.hpp>

namespace gs::shared_memory_io {

static_assert(settings_storage::kSlots <= static_cast<int>(kFlashSlots));
static_assert(settings_storage::kSlotBytes <= kFlashSlotBytes);

volatile std::uint32_t& SharedFlash::word(int slot, std::size_t offset) const {
  return *reinterpret_cast<volatile std::uint32_t*>(terminals_.flash[slot] + offset);
}

bool SharedFlash::erase(int slot) {
  for (std::size_t at = 0; at < kFlashSlotBytes; at += sizeof(std::uint32_t)) {
    word(slot, at) = 0xFFFFFFFFu;
  }
  return true;
}

bool SharedFlash::program(int slot, std::size_t offset, std::uint32_t value) {
  // As flash does: bits go from 1 to 0 only.
  word(slot, offset) = word(slot, offset) & value;
  return true;
}

std::uint32_t SharedFlash::read(int slot, std::size_t offset) const {
  return word(slot, offset);
}

}  // namespace gs::shared_memory_io
