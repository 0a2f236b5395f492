#include "stm32_board.hpp"

#include <cortex_m4/core.hpp>
#include <stm32f405_chip/chip.hpp>

#include <algorithm>

#include <outlet/crc32.hpp>

namespace gs::stm32f405 {
namespace {

using cortex_m4::InterruptsMasked;

constexpr std::int16_t kMiddle = 2048;  // of 12 bits
constexpr unsigned kMainsPin = 1;       // of port A
constexpr unsigned kRelayPin = 6;       // of port C

}  // namespace

std::uint32_t instance() {
  std::uint8_t id[kUniqueIdBytes];
  read_unique_id(id);
  if (std::all_of(id, id + kUniqueIdBytes, [](std::uint8_t byte) { return byte == 0; })) {
    return 0;
  }
  outlet::Crc32 crc;
  crc.add(id, kUniqueIdBytes);
  return crc.value();
}

Stm32Board::Stm32Board() {}

void Stm32Board::start(const Clocks& clocks) {
  start_pins();
  link_.start(clocks.apb2_hz);
  start_adc(clocks.apb1_timer_hz);
  // 32 kHz / 64: resets after 2 s nominally, 1.4 … 3.8 s by the datasheet. This is longer than the
  // erase of a sector.
  start_watchdog(4, 1000);
}

void Stm32Board::start_pins() {
  RCC->AHB1ENR = RCC->AHB1ENR | RCC_AHB1ENR_GPIOAEN | RCC_AHB1ENR_GPIOCEN | RCC_AHB1ENR_DMA2EN;
  RCC->APB1ENR = RCC->APB1ENR | RCC_APB1ENR_TIM2EN | RCC_APB1ENR_TIM3EN;
  RCC->APB2ENR = RCC->APB2ENR | RCC_APB2ENR_USART1EN | RCC_APB2ENR_ADC1EN;
  static_cast<void>(RCC->APB2ENR);  // a clock is available two cycles after it is enabled
  set_mode(*GPIOA, kMainsPin, GPIO_MODER_ANALOG);
  drive_relay(true);  // before the pin becomes an output, so that the load is not interrupted
  set_mode(*GPIOC, kRelayPin, GPIO_MODER_OUTPUT);
}

// Timer 3 starts each conversion and timer 2 counts them, so that the number of lost samples is
// known even if the processor was stalled.
void Stm32Board::start_adc(std::uint32_t timer_hz) {
  DmaStream& stream = DMA2->S[0];
  stream.PAR = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&ADC1->DR));
  stream.M0AR = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(converted_));
  stream.NDTR = 2 * kBlock;
  stream.CR = DMA_SxCR_PL_HIGH | DMA_SxCR_MSIZE_16 | DMA_SxCR_PSIZE_16 | DMA_SxCR_MINC |
              DMA_SxCR_CIRC | DMA_SxCR_HTIE | DMA_SxCR_TCIE | DMA_SxCR_EN;
  cortex_m4::enable_interrupt(kDma2Stream0Irq);

  ADC->CCR = ADC_CCR_ADCPRE_DIV4;       // 84 MHz / 4 = 21 MHz; maximum 36 MHz (datasheet, table 67)
  ADC1->SMPR2 = 4u << (3 * kMainsPin);  // sampling time 84 cycles, 4 µs
  ADC1->SQR3 = kMainsPin;
  ADC1->CR2 =
      ADC_CR2_ADON | ADC_CR2_DMA | ADC_CR2_DDS | ADC_CR2_EXTSEL_TIM3_TRGO | ADC_CR2_EXTEN_RISING;

  TIM2->ARR = 0xFFFFFFFFu;
  TIM2->SMCR = TIM_SMCR_SMS_EXTERNAL1 | TIM_SMCR_TS_ITR2;
  TIM2->CR1 = TIM_CR1_CEN;
  TIM3->ARR = timer_hz / static_cast<std::uint32_t>(kSampleRate_hz) - 1;
  TIM3->CR2 = TIM_CR2_MMS_UPDATE;
  TIM3->CR1 = TIM_CR1_CEN;
}

void Stm32Board::sleep() {
  cortex_m4::sleep_unless([this] { return link_.has_received() || !samples_.idle(); });
}

bool Stm32Board::send(const std::uint8_t* bytes, std::size_t count) {
  return link_.send(bytes, count);
}

std::size_t Stm32Board::take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) {
  const InterruptsMasked masked;
  return samples_.take(out, most, lost);
}

bool Stm32Board::take_byte(std::uint8_t& byte) {
  return link_.take(byte);
}

void Stm32Board::drive_relay(bool closed) {
  GPIOC->BSRR = closed ? 1u << kRelayPin : 1u << (kRelayPin + 16);
}

void Stm32Board::feed_watchdog() {
  stm32f405::feed_watchdog();
}

// Handles each full half of converted_.
void Stm32Board::on_samples() {
  DMA2->LIFCR = DMA_LIFCR_STREAM0;
  const std::uint32_t end = TIM2->CNT / kBlock * kBlock;
  const std::uint32_t blocks = (end - blocks_end_) / kBlock;
  if (blocks == 0) {
    return;
  }
  if (blocks > 1) {
    samples_.lose((blocks - 1) * kBlock);
  }
  const volatile std::uint16_t* half = converted_ + (end - kBlock) % (2 * kBlock);
  std::int16_t block[kBlock];
  for (std::uint32_t i = 0; i < kBlock; ++i) {
    block[i] = static_cast<std::int16_t>(static_cast<std::int16_t>(half[i]) - kMiddle);
  }
  samples_.put(block, kBlock);
  blocks_end_ = end;
}

}  // namespace gs::stm32f405
