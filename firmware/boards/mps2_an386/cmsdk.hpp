// Peripherals of ARM's Cortex-M System Design Kit (CMSDK) at their addresses in AN386, with the
// manual's register names.
#pragma once

#include <cortex_m4/core.hpp>

#include <cstdint>

namespace gs::mps2_an386 {

constexpr std::uint32_t kClock_hz = 25'000'000;

struct Uart {
  volatile std::uint32_t DATA, STATE, CTRL, INTSTATUS, BAUDDIV;
};
constexpr std::uint32_t kStateTxFull = 1u << 0, kStateRxFull = 1u << 1;
constexpr std::uint32_t kCtrlTxEnable = 1u << 0, kCtrlRxEnable = 1u << 1;
constexpr std::uint32_t kCtrlTxInterrupt = 1u << 2, kCtrlRxInterrupt = 1u << 3;
constexpr std::uint32_t kIntTx = 1u << 0, kIntRx = 1u << 1;

constexpr cortex_m4::At<Uart, 0x40004000u> uart0;
constexpr cortex_m4::At<Uart, 0x40005000u> uart1;
constexpr unsigned kUart0RxIrq = 0, kUart0TxIrq = 1, kUart1RxIrq = 2;

struct Watchdog {
  volatile std::uint32_t LOAD, VALUE, CONTROL, INTCLR;
};
constexpr std::uint32_t kWatchdogInterrupt = 1u << 0, kWatchdogReset = 1u << 1;

constexpr cortex_m4::At<Watchdog, 0x40008000u> watchdog;

}  // namespace gs::mps2_an386
