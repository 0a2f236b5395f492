#include "sector_flash.hpp"

#include <stm32f405_chip/rm0090.hpp>

namespace gs::stm32f405 {
namespace {

constexpr std::uintptr_t kFirstSlot = 0x08004000u;
constexpr std::size_t kSectorBytes = 16 * 1024;
constexpr std::uint32_t kFirstSector = 1;
// Far more than an erase needs: code in flash is stalled until the flash is ready.
constexpr int kErasePolls = 20'000'000;

volatile std::uint32_t& word_of(int slot, std::size_t offset) {
  return *reinterpret_cast<volatile std::uint32_t*>(
      kFirstSlot + static_cast<std::size_t>(slot) * kSectorBytes + offset);
}

bool finish() {
  for (int poll = 0; poll < kErasePolls; ++poll) {
    if ((FLASH->SR & FLASH_SR_BSY) == 0) {
      return (FLASH->SR & FLASH_SR_ERRORS) == 0;
    }
  }
  return false;
}

// Unlocks the flash for erasing and programming in its scope.
class Unlocked {
 public:
  Unlocked() {
    FLASH->KEYR = 0x45670123u;
    FLASH->KEYR = 0xCDEF89ABu;
    FLASH->SR = FLASH_SR_ERRORS;  // clears earlier errors (write 1 to clear)
  }
  ~Unlocked() { FLASH->CR = FLASH_CR_LOCK; }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
};

}  // namespace

bool SectorFlash::erase(int slot) {
  const Unlocked unlocked;
  const std::uint32_t sector = kFirstSector + static_cast<std::uint32_t>(slot);
  FLASH->CR = FLASH_CR_SER | FLASH_CR_PSIZE_X32 | sector << FLASH_CR_SNB_Pos;
  FLASH->CR = FLASH->CR | FLASH_CR_STRT;
  return finish();
}

bool SectorFlash::program(int slot, std::size_t offset, std::uint32_t word) {
  const Unlocked unlocked;
  FLASH->CR = FLASH_CR_PG | FLASH_CR_PSIZE_X32;
  word_of(slot, offset) = word;
  return finish();
}

std::uint32_t SectorFlash::read(int slot, std::size_t offset) const {
  return word_of(slot, offset);
}

}  // namespace gs::stm32f405
