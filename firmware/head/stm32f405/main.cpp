#include "head_board.hpp"
#include <cortex_m4/vectors.hpp>
#include <stm32f405_chip/chip.hpp>

#include <algorithm>

namespace gs::stm32f405 {
namespace {

HeadBoard* board = nullptr;

head::Hardware hardware(const Clocks& clocks) {
  constexpr char kBoard[] = "stm32f405";
  head::Hardware hardware;
  std::copy(kBoard, kBoard + sizeof kBoard, hardware.board);
  read_unique_id(hardware.unique_id);
  hardware.build = GSBENCH_FIRMWARE_BUILD;
  if (clocks.crystal_runs) {
    hardware.flags = head::kCrystalRuns;
  }
  if (reset_by_watchdog()) {
    hardware.flags = static_cast<std::uint16_t>(hardware.flags | head::kRestartedByWatchdog);
  }
  hardware.counts_per_sample = clocks.apb1_timer_hz / head::kSampleRate_hz;
  return hardware;
}

__attribute__((section(".vectors"), used)) const cortex_m4::VectorTable<kInterrupts> vectors = [] {
  cortex_m4::VectorTable<kInterrupts> table;
  table.interrupts[kDma1Stream5Irq] = [] { board->on_codes(); };
  table.interrupts[kTim2Irq] = [] { board->on_capture(); };
  table.interrupts[kUsart1Irq] = [] { board->on_usart(); };
  table.interrupts[kTim6DacIrq] = [] { board->on_dac_starved(); };
  return table;
}();

}  // namespace
}  // namespace gs::stm32f405

int main() {
  using namespace gs::stm32f405;
  const Clocks clocks = start_clocks();
  static HeadBoard the_board(clocks, hardware(clocks));
  board = &the_board;
  the_board.start();
  for (;;) {
    the_board.turn();
    the_board.sleep();
  }
}
