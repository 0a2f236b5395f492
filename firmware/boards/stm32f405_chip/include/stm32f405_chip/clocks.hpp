// Clock tree: 8 MHz crystal → PLL → 168 MHz; APB2 84 MHz, timers of APB1 84 MHz and of
// APB2 168 MHz.
#pragma once

#include <cstdint>

namespace gs::stm32f405 {

struct Clocks {
  std::uint32_t apb2_hz;
  std::uint32_t apb1_timer_hz;
  std::uint32_t apb2_timer_hz;
  bool crystal_runs;  // false: clocked by the internal oscillator, accurate to about 1 %
};

// If the crystal does not start, the PLL runs from the internal oscillator (HSI), with the same
// frequencies. If the PLL does not start either, the clock is the HSI's 16 MHz. Blocks until
// the clocks run or time out.
Clocks start_clocks();

}  // namespace gs::stm32f405
