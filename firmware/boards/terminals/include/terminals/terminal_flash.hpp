// An emulated outlet's flash: bytes in the terminals, that outlive its process.
#pragma once

#include <settings_area/settings_area.hpp>

#include <terminals/terminals.hpp>

namespace gs::terminals {

class TerminalFlash final : public settings_area::Flash {
 public:
  explicit TerminalFlash(Terminals& terminals) : terminals_(terminals) {}

  bool erase(int slot) override;
  bool program(int slot, std::size_t offset, std::uint32_t word) override;
  std::uint32_t read(int slot, std::size_t offset) const override;

 private:
  volatile std::uint32_t& word(int slot, std::size_t offset) const;

  Terminals& terminals_;
};

}  // namespace gs::terminals
