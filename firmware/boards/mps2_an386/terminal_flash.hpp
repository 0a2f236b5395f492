// The emulated outlet's flash: bytes in the terminals, that outlive the emulator.
#pragma once

#include <settings_area/settings_area.hpp>

#include <terminals/terminals.hpp>

namespace gs::mps2_an386 {

class TerminalFlash final : public settings_area::Flash {
 public:
  explicit TerminalFlash(terminals::Terminals& terminals) : terminals_(terminals) {}

  bool erase(int slot) override;
  bool program(int slot, std::size_t offset, std::uint32_t word) override;
  std::uint32_t read(int slot, std::size_t offset) const override;

 private:
  volatile std::uint32_t& word(int slot, std::size_t offset) const;

  terminals::Terminals& terminals_;
};

}  // namespace gs::mps2_an386
