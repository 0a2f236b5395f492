#include "cmsdk.hpp"
#include "mps2_board.hpp"
#include <cortex_m4/core.hpp>
#include <cortex_m4/vectors.hpp>
#include <shared_memory_io/shared_flash.hpp>

#include <superloop/loop.hpp>

namespace gs::mps2_an386 {
namespace {

shared_memory_io::SharedMemory& terminals() {
  return *reinterpret_cast<shared_memory_io::SharedMemory*>(0x21000000u);  // PSRAM
}

bool wired() {
  return *static_cast<const volatile std::uint32_t*>(&terminals().magic) ==
         shared_memory_io::kMagic;
}

Mps2Board& board() {
  static Mps2Board board(terminals());
  return board;
}

superloop::StartUp start_up() {
  superloop::StartUp start_up;
  start_up.hardware = {terminals().sample_rate_hz, terminals().nominal_hz,
                       terminals().counts_per_pu, terminals().crystal_fails == 0};
  app::set_text(start_up.identity.id, terminals().id);
  app::set_text(start_up.identity.board, "mps2-an386");
  start_up.identity.instance = terminals().instance;
  start_up.identity.build = GSBENCH_FIRMWARE_BUILD;
  start_up.identity.capabilities = wire::kKeepsSettings | wire::kHasWatchdog;
  start_up.identity.start_number = terminals().starts;
  start_up.reset_by_watchdog = reset_by_watchdog();
  return start_up;
}

// The bench sends one byte, of any value, after each block of samples.
void on_doorbell() {
  uart1->INTSTATUS = kIntRx;
  while ((uart1->STATE & kStateRxFull) != 0) {
    static_cast<void>(uart1->DATA);
  }
}

__attribute__((section(".vectors"), used)) const cortex_m4::VectorTable<3> vectors = [] {
  cortex_m4::VectorTable<3> table;
  table.nmi = note_watchdog;
  table.systick = [] {};  // only wakes the loop
  table.interrupts[kUart0RxIrq] = [] { board().on_receive(); };
  table.interrupts[kUart0TxIrq] = [] { board().on_transmit(); };
  table.interrupts[kUart1RxIrq] = on_doorbell;
  return table;
}();

}  // namespace
}  // namespace gs::mps2_an386

int main() {
  using namespace gs;
  // Waits until the bench has written the terminals.
  while (!mps2_an386::wired()) {
  }
  mps2_an386::Mps2Board& board = mps2_an386::board();
  board.start();
  static shared_memory_io::SharedFlash flash(mps2_an386::terminals());
  static settings_storage::FlashSettingsStorage storage(flash);
  static superloop::Loop loop(board, storage);
  loop.start(mps2_an386::start_up());
  for (;;) {
    if (!loop.turn()) {
      board.sleep();
    }
  }
}
