#include <stm32f405_chip/clocks.hpp>
#include <stm32f405_chip/rm0090.hpp>

namespace gs::stm32f405 {
namespace {

constexpr std::uint32_t kHsi_hz = 16'000'000;
constexpr std::uint32_t kCrystal_hz = 8'000'000;
constexpr std::uint32_t kPll_hz = 168'000'000;
// A poll takes at least ten cycles of 16 MHz, so that this is at least 60 ms: thirty times a
// crystal's start-up time (datasheet, table 39), a thousand times the PLL's.
constexpr int kPolls = 100'000;

bool comes(Register& status, std::uint32_t bits, std::uint32_t wanted) {
  for (int poll = 0; poll < kPolls; ++poll) {
    if ((status & bits) == wanted) {
      return true;
    }
  }
  return false;
}

// Input divided to 1 MHz, × 336, / 2. The / 7 keeps the unused USB clock in range.
bool start_pll(std::uint32_t input_hz, std::uint32_t source) {
  RCC->CR = RCC->CR & ~RCC_CR_PLLON;
  if (!comes(RCC->CR, RCC_CR_PLLRDY, 0)) {
    return false;
  }
  RCC->PLLCFGR = input_hz / 1'000'000u | 336u << 6 | 7u << 24 | source;
  RCC->CR = RCC->CR | RCC_CR_PLLON;
  return comes(RCC->CR, RCC_CR_PLLRDY, RCC_CR_PLLRDY);
}

bool run_on_pll() {
  FLASH->ACR = FLASH_ACR_LATENCY_5WS | FLASH_ACR_PRFTEN | FLASH_ACR_ICEN;
  RCC->CFGR = RCC_CFGR_PPRE1_DIV4 | RCC_CFGR_PPRE2_DIV2 | RCC_CFGR_SW_PLL;
  if (comes(RCC->CFGR, RCC_CFGR_SWS, RCC_CFGR_SWS_PLL)) {
    return true;
  }
  RCC->CFGR = 0;
  return false;
}

}  // namespace

Clocks start_clocks() {
  RCC->CR = RCC->CR | RCC_CR_HSEON;
  const bool crystal = comes(RCC->CR, RCC_CR_HSERDY, RCC_CR_HSERDY);
  if (crystal && start_pll(kCrystal_hz, RCC_PLLCFGR_PLLSRC_HSE) && run_on_pll()) {
    return {kPll_hz / 2, kPll_hz / 2, kPll_hz, true};
  }
  if (start_pll(kHsi_hz, 0) && run_on_pll()) {
    return {kPll_hz / 2, kPll_hz / 2, kPll_hz, false};
  }
  return {kHsi_hz, kHsi_hz, kHsi_hz, false};
}

}  // namespace gs::stm32f405
