#include <terminals/terminal_flash.hpp>

namespace gs::terminals {

static_assert(settings_area::kSlots <= static_cast<int>(kFlashSlots));
static_assert(settings_area::kSlotBytes <= kFlashSlotBytes);

volatile std::uint32_t& TerminalFlash::word(int slot, std::size_t offset) const {
  return *reinterpret_cast<volatile std::uint32_t*>(terminals_.flash[slot] + offset);
}

bool TerminalFlash::erase(int slot) {
  for (std::size_t at = 0; at < kFlashSlotBytes; at += sizeof(std::uint32_t)) {
    word(slot, at) = 0xFFFFFFFFu;
  }
  return true;
}

bool TerminalFlash::program(int slot, std::size_t offset, std::uint32_t value) {
  // As flash does: bits go from 1 to 0 only.
  word(slot, offset) = word(slot, offset) & value;
  return true;
}

std::uint32_t TerminalFlash::read(int slot, std::size_t offset) const {
  return word(slot, offset);
}

}  // namespace gs::terminals
