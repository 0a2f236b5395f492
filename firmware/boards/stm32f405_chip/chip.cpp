#include <stm32f405_chip/chip.hpp>

#include <algorithm>

namespace gs::stm32f405 {

void set_mode(Gpio& port, unsigned pin, std::uint32_t mode) {
  port.MODER = (port.MODER & ~(3u << (2 * pin))) | mode << (2 * pin);
}

void set_function(Gpio& port, unsigned pin, std::uint32_t function) {
  Register& half = port.AFR[pin / 8];
  const unsigned shift = 4 * (pin % 8);
  half = (half & ~(15u << shift)) | function << shift;
  set_mode(port, pin, GPIO_MODER_ALTERNATE);
}

void pull_up(Gpio& port, unsigned pin) {
  port.PUPDR = (port.PUPDR & ~(3u << (2 * pin))) | 1u << (2 * pin);
}

bool reset_by_watchdog() {
  const bool expired = (RCC->CSR & RCC_CSR_IWDGRSTF) != 0;
  RCC->CSR = RCC->CSR | RCC_CSR_RMVF;
  return expired;
}

void start_watchdog(std::uint32_t prescaler, std::uint32_t ticks) {
  IWDG->KR = IWDG_KR_UNLOCK;
  IWDG->PR = prescaler;
  IWDG->RLR = ticks;
  IWDG->KR = IWDG_KR_START;
}

std::uint32_t random_number() {
  // A number takes 40 cycles of 48 MHz, 140 of the processor's.
  constexpr int kPolls = 1000;
  RCC->AHB2ENR = RCC->AHB2ENR | RCC_AHB2ENR_RNGEN;
  RNG->CR = RNG_CR_RNGEN;
  std::uint32_t number = 0;
  // The first number after the start must not be used (RM0090, 24.3.1).
  for (int numbers = 0, poll = 0; numbers < 2 && poll < kPolls; ++poll) {
    if ((RNG->SR & RNG_SR_DRDY) != 0) {
      number = RNG->DR;
      ++numbers;
    }
  }
  return number;
}

void read_unique_id(std::uint8_t (&id)[kUniqueIdBytes]) {
  std::fill(id, id + kUniqueIdBytes, std::uint8_t{0});
  // On other chips or in an emulator, reading the unique id's address may fault.
  if ((*DBGMCU_IDCODE & DBGMCU_IDCODE_DEV_ID) == kF405) {
    const auto* bytes = reinterpret_cast<const volatile std::uint8_t*>(kUniqueId);
    std::copy(bytes, bytes + kUniqueIdBytes, id);
  }
}

}  // namespace gs::stm32f405
