#include "mps2_board.hpp"

#include "cmsdk.hpp"
#include <cortex_m4/core.hpp>

#include <initializer_list>

namespace gs::mps2_an386 {
namespace {

using cortex_m4::InterruptsMasked;
using shared_memory_io::kRingSamples;

constexpr std::uint32_t kBaud = 921'600;
// The emulator runs on wall time, and its machine may be busy. Hence the long times: a warning
// after 5 s, the reset after another 5 s.
constexpr std::uint32_t kWatchdogTicks = 5 * kClock_hz;
// Wakes the loop to feed the watchdog while no samples and no bytes arrive.
constexpr std::uint32_t kTurnTicks = kClock_hz / 2;

// Upper bound of a report's messages, with event, estimate, decision and relay.
constexpr std::size_t kReportBytes = 384;

constexpr std::uint32_t kExpired = 0x4241524Bu;  // "BARK"
__attribute__((section(".noinit"))) volatile std::uint32_t expired;

}  // namespace

bool reset_by_watchdog() {
  const bool was = expired == kExpired;
  expired = 0;
  return was;
}

void note_watchdog() {
  expired = kExpired;
}

void Mps2Board::start() {
  port_.start();
  uart0->BAUDDIV = kClock_hz / kBaud;
  uart0->CTRL = kCtrlTxEnable | kCtrlRxEnable | kCtrlTxInterrupt | kCtrlRxInterrupt;
  uart1->BAUDDIV = kClock_hz / kBaud;
  uart1->CTRL = kCtrlRxEnable | kCtrlRxInterrupt;
  for (const unsigned irq : {kUart0RxIrq, kUart0TxIrq, kUart1RxIrq}) {
    cortex_m4::enable_interrupt(irq);
  }
  watchdog->LOAD = kWatchdogTicks;
  watchdog->CONTROL = kWatchdogInterrupt | kWatchdogReset;
  cortex_m4::start_systick(kTurnTicks);
}

void Mps2Board::sleep() {
  cortex_m4::sleep_unless([this] { return received_.used() > 0 || !adc_idle(); });
}

bool Mps2Board::adc_idle() const {
  const std::uint32_t waiting = terminals_.written - terminals_.taken;
  return waiting == 0 || (waiting <= kRingSamples / 2 && to_send_.room() < kReportBytes);
}

bool Mps2Board::send(const std::uint8_t* bytes, std::size_t count) {
  const InterruptsMasked masked;
  const bool taken = to_send_.put(bytes, count);
  pump();
  return taken;
}

std::size_t Mps2Board::take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) {
  lost = 0;
  if (adc_idle()) {
    return 0;
  }
  return port_.take_samples(out, most, lost);
}

bool Mps2Board::take_byte(std::uint8_t& byte) {
  return received_.take(byte);
}

void Mps2Board::feed_watchdog() {
  watchdog->INTCLR = 1;  // also reloads the counter
  expired = 0;
}

void Mps2Board::on_receive() {
  // Cleared first, so that a byte that arrives during the reads raises the interrupt again.
  uart0->INTSTATUS = kIntRx;
  while ((uart0->STATE & kStateRxFull) != 0) {
    // If the queue is full, the byte is lost and its frame is reported as bad.
    received_.put(static_cast<std::uint8_t>(uart0->DATA));
  }
}

void Mps2Board::on_transmit() {
  uart0->INTSTATUS = kIntTx;
  pump();
}

void Mps2Board::pump() {
  std::uint8_t byte = 0;
  while ((uart0->STATE & kStateTxFull) == 0 && to_send_.take(byte)) {
    uart0->DATA = byte;
  }
}

}  // namespace gs::mps2_an386
