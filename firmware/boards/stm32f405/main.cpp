#include "sector_flash.hpp"
#include "stm32_board.hpp"
#include <cortex_m4/core.hpp>
#include <cortex_m4/vectors.hpp>
#include <stm32f405_chip/chip.hpp>

#include <superloop/loop.hpp>

namespace gs::stm32f405 {
namespace {

Stm32Board& board() {
  static Stm32Board board;
  return board;
}

// "stm32-0123abcd", from the chip's unique id, until ids are assigned at manufacture.
void set_default_id(char (&id)[wire::kLongestId + 1], std::uint32_t number) {
  app::set_text(id, "stm32-00000000");
  for (int digit = 0; digit < 8; ++digit) {
    id[6 + digit] = "0123456789abcdef"[number >> (28 - 4 * digit) & 15u];
  }
}

__attribute__((section(".noinit"))) volatile std::uint32_t last_start;

// Random. Without the generator it still differs from the last start, unless power was lost.
std::uint32_t start_number() {
  last_start = (last_start + 1) ^ random_number();
  return last_start;
}

superloop::StartUp start_up(const Clocks& clocks) {
  superloop::StartUp start_up;
  start_up.hardware = {kSampleRate_hz, 50, kCounts_per_pu, clocks.crystal_runs};
  start_up.identity.instance = instance();
  set_default_id(start_up.identity.id, start_up.identity.instance);
  app::set_text(start_up.identity.board, "stm32f405");
  start_up.identity.build = GSBENCH_FIRMWARE_BUILD;
  start_up.identity.capabilities = wire::kKeepsSettings | wire::kHasWatchdog;
  start_up.identity.start_number = start_number();
  start_up.reset_by_watchdog = reset_by_watchdog();
  return start_up;
}

__attribute__((section(".vectors"), used)) const cortex_m4::VectorTable<kInterrupts> vectors = [] {
  cortex_m4::VectorTable<kInterrupts> table;
  table.interrupts[kUsart1Irq] = [] { board().on_usart(); };
  table.interrupts[kDma2Stream0Irq] = [] { board().on_samples(); };
  return table;
}();

}  // namespace
}  // namespace gs::stm32f405

int main() {
  using namespace gs;
  const stm32f405::Clocks clocks = stm32f405::start_clocks();
  stm32f405::Stm32Board& board = stm32f405::board();
  static stm32f405::SectorFlash flash;
  static settings_storage::FlashSettingsStorage storage(flash);
  static superloop::Loop loop(board, storage);
  board.start(clocks);
  loop.start(stm32f405::start_up(clocks));
  for (;;) {
    if (!loop.turn()) {
      board.sleep();
    }
  }
}
