// The processor's registers and instructions that the boards use (ARMv7-M Architecture Reference
// Manual, B3).
#pragma once

#include <cstdint>

namespace gs::cortex_m4 {

inline volatile std::uint32_t& word_at(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

// A block of registers at its address, accessed by the manual's names: TIM2->CNT.
template <class Block, std::uintptr_t kAddress>
struct At {
  Block& operator*() const { return *reinterpret_cast<Block*>(kAddress); }
  Block* operator->() const { return &**this; }
};

struct SysTick {
  volatile std::uint32_t CSR, RVR, CVR, CALIB;
};
constexpr At<SysTick, 0xE000E010u> systick;

// Starts SysTick: one interrupt every `cycles` clock cycles of the processor, at most 2^24.
inline void start_systick(std::uint32_t cycles) {
  constexpr std::uint32_t kEnable = 1u, kInterrupt = 2u, kProcessorClock = 4u;
  systick->RVR = cycles - 1;
  systick->CVR = 0;
  systick->CSR = kEnable | kInterrupt | kProcessorClock;
}

inline void enable_interrupt(unsigned number) {
  word_at(0xE000E100u + 4 * (number / 32)) = 1u << (number % 32);
}

// 0 is the most urgent of the 16 priorities of the chips in use, and that after reset. Interrupts
// of one priority do not interrupt each other.
inline void set_priority(unsigned number, std::uint8_t priority) {
  *reinterpret_cast<volatile std::uint8_t*>(0xE000E400u + number) =
      static_cast<std::uint8_t>(priority << 4);
}

// Masks interrupts while the object exists. The NMI and faults are not masked. Must not be nested.
class InterruptsMasked {
 public:
  InterruptsMasked() { asm volatile("cpsid i" ::: "memory"); }
  ~InterruptsMasked() { asm volatile("cpsie i\n\tisb" ::: "memory"); }
  InterruptsMasked(const InterruptsMasked&) = delete;
  InterruptsMasked& operator=(const InterruptsMasked&) = delete;
};

// Sleeps until an interrupt if `work_waits()` returns false. Interrupts are masked during the check
// and the sleep. An interrupt that arrives between the check and the WFI instruction stays pending,
// and wakes the processor at once.
template <class Predicate>
void sleep_unless(Predicate work_waits) {
  const InterruptsMasked masked;
  if (!work_waits()) {
    asm volatile("dsb\n\twfi" ::: "memory");
  }
}

}  // namespace gs::cortex_m4
