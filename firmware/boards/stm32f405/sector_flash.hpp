// Settings in sectors 1 and 2 of the flash. memory.ld explains why in these sectors.
//
// Erasing a sector stalls the processor for up to half a second. The samples of that time are lost,
// and the outlet reports their number. Settings should be sent while the grid is quiet.
#pragma once

#include <settings_storage/settings_storage.hpp>

namespace gs::stm32f405 {

class SectorFlash final : public settings_storage::Flash {
 public:
  bool erase(int slot) override;
  bool program(int slot, std::size_t offset, std::uint32_t word) override;
  std::uint32_t read(int slot, std::size_t offset) const override;
};

}  // namespace gs::stm32f405
