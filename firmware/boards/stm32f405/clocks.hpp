// The clock tree: crystal of 8 MHz → PLL → 168 MHz; APB2 84 MHz, timers of APB1 84 MHz.
#pragma once

#include <cstdint>

namespace gs::stm32f405 {

struct Clocks {
  std::uint32_t apb2_hz;
  std::uint32_t apb1_timer_hz;
  bool crystal_runs;  // else they are the chip's own oscillator's, good to about 1 %
};

// With a crystal that does not start, the same frequencies from the chip's own oscillator; where
// the PLL does not start either, that oscillator's 16 MHz.
Clocks start_clocks();

}  // namespace gs::stm32f405
