#include "head_board.hpp"

#include <cortex_m4/core.hpp>
#include <stm32f405_chip/chip.hpp>

namespace gs::stm32f405 {
namespace {

using cortex_m4::InterruptsMasked;

constexpr unsigned kDacPin = 4;                               // of port A, like all below
constexpr unsigned kInputPins[head::kInputs] = {5, 1, 2, 3};  // channels 1 … 4 of timer 2
constexpr std::uint32_t kTimer2Function = 1;
// The link has no buffer in hardware: a byte every 11 µs. Codes and captures share a priority, so
// that they do not interrupt each other.
constexpr std::uint8_t kLinkPriority = 0, kTimingPriority = 1;
// The input filter: 8 samples at 1/128 of the timer's clock. An edge is seen 7 … 8 samples later.
constexpr std::uint64_t kFilter_counts = 7 * 128 + 64;

std::uint32_t address_of(volatile void* place) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(place));
}

std::uint8_t closed_inputs() {
  const std::uint32_t pins = GPIOA->IDR;
  unsigned closed = 0;
  for (std::size_t input = 0; input < head::kInputs; ++input) {
    closed |= (pins >> kInputPins[input] & 1u) == 0 ? 1u << input : 0u;
  }
  return static_cast<std::uint8_t>(closed);
}

}  // namespace

HeadBoard::HeadBoard(const Clocks& clocks, const head::Hardware& hardware)
    : clocks_(clocks),
      counts_per_sample_(hardware.counts_per_sample),
      head_(hardware),
      contacts_(head_) {}

void HeadBoard::start() {
  RCC->AHB1ENR = RCC->AHB1ENR | RCC_AHB1ENR_GPIOAEN | RCC_AHB1ENR_DMA1EN;
  RCC->APB1ENR = RCC->APB1ENR | RCC_APB1ENR_TIM2EN | RCC_APB1ENR_DACEN;
  RCC->APB2ENR = RCC->APB2ENR | RCC_APB2ENR_USART1EN | RCC_APB2ENR_TIM8EN;
  static_cast<void>(RCC->APB2ENR);  // a clock is available two cycles after it is enabled
  cortex_m4::set_priority(kUsart1Irq, kLinkPriority);
  cortex_m4::set_priority(kDma1Stream5Irq, kTimingPriority);
  cortex_m4::set_priority(kTim6DacIrq, kTimingPriority);
  cortex_m4::set_priority(kTim2Irq, kTimingPriority);
  for (const unsigned pin : kInputPins) {
    pull_up(*GPIOA, pin);  // first, so that the inputs are at rest when they are read
  }
  start_dac();
  start_inputs();
  start_timers();
  link_.start(clocks_.apb2_hz);
  // 32 kHz / 4: resets after 125 ms nominally, 85 … 235 ms by the datasheet. So the output is off
  // in time also if the firmware hangs.
  start_watchdog(0, 1000);
}

void HeadBoard::start_dac() {
  for (volatile std::uint16_t& code : codes_) {
    code = head::kMidScale;
  }
  set_mode(*GPIOA, kDacPin, GPIO_MODER_ANALOG);
  // Without a trigger yet, so that the output is at mid-scale when it is enabled.
  DAC->DHR12R1 = head::kMidScale;
  DmaStream& stream = DMA1->S[5];
  stream.PAR = address_of(&DAC->DHR12R1);
  stream.M0AR = address_of(codes_);
  stream.NDTR = 2 * kBlock;
  stream.CR = DMA_SxCR_CHSEL_7 | DMA_SxCR_PL_HIGH | DMA_SxCR_MSIZE_16 | DMA_SxCR_PSIZE_16 |
              DMA_SxCR_MINC | DMA_SxCR_CIRC | DMA_SxCR_DIR_FROM_MEMORY | DMA_SxCR_HTIE |
              DMA_SxCR_TCIE | DMA_SxCR_EN;
  cortex_m4::enable_interrupt(kDma1Stream5Irq);
  DAC->CR = DAC_CR_EN1;
  DAC->CR = DAC_CR_EN1 | DAC_CR_TSEL1_TIM8 | DAC_CR_TEN1 | DAC_CR_DMAEN1 | DAC_CR_DMAUDRIE1;
  cortex_m4::enable_interrupt(kTim6DacIrq);
}

void HeadBoard::start_inputs() {
  for (const unsigned pin : kInputPins) {
    set_function(*GPIOA, pin, kTimer2Function);
  }
  TIM2->ARR = 0xFFFFFFFFu;
  constexpr std::uint32_t kChannel = TIM_CCMR_CAPTURE | TIM_CCMR_FILTER_DIV32_8;
  TIM2->CCMR1 = kChannel | kChannel << 8;
  TIM2->CCMR2 = kChannel | kChannel << 8;
  std::uint32_t enable = 0;
  std::uint32_t interrupts = 0;
  for (unsigned channel = 0; channel < head::kInputs; ++channel) {
    enable |= TIM_CCER_BOTH_EDGES << (4 * channel);
    interrupts |= TIM_SR_CCIF(channel);  // DIER has them at the same bits
  }
  TIM2->CCER = enable;
  TIM2->DIER = interrupts;
}

// Timer 8 runs at twice the clock of timer 2: 84 MHz cannot be divided to 64 kHz, 168 MHz can.
void HeadBoard::start_timers() {
  TIM8->ARR = clocks_.apb2_timer_hz / head::kCodeRate_hz - 1;
  TIM8->CR2 = TIM_CR2_MMS_UPDATE;
  TIM8->SMCR = TIM_SMCR_SMS_TRIGGER | TIM_SMCR_TS_ITR1;  // started by timer 2
  TIM2->CR2 = TIM_CR2_MMS_ENABLE;
  TIM2->CR1 = TIM_CR1_CKD_DIV4 | TIM_CR1_CEN;
  TIM2->SR = 0;  // captures that precede the state that is read now
  contacts_.start(closed_inputs());
  cortex_m4::enable_interrupt(kTim2Irq);
}

void HeadBoard::turn() {
  // At most one frame, so that a flood of bytes cannot delay what is to be sent.
  std::uint8_t byte = 0;
  for (std::size_t taken = 0; taken < wire::kLongestFrame && link_.take(byte); ++taken) {
    switch (reader_.take(byte)) {
      case wire::FrameReader::Taken::kMessage:
        head_.take(reader_.message(), reader_.size());
        break;
      case wire::FrameReader::Taken::kBadFrame:
        head_.bad_frame();
        break;
      case wire::FrameReader::Taken::kNothing:
        break;
    }
  }
  send_messages();
  feed_watchdog();
}

void HeadBoard::send_messages() {
  constexpr std::size_t kLongest = 128;  // frame of a message of kLongestUplink
  static_assert(head::kLongestUplink + wire::kCrcLength + 4 <= kLongest);
  std::uint8_t message[head::kLongestUplink];
  std::uint8_t frame[kLongest];
  while (link_.room() >= kLongest) {
    const std::size_t size = head_.next_message(now(), message, sizeof message);
    if (size == 0) {
      return;
    }
    link_.send(frame, wire::frame(message, size, frame, sizeof frame));
  }
}

// Only while codes are made: the watchdog must restart a head whose DAC stands still.
void HeadBoard::feed_watchdog() {
  const std::uint32_t blocks = blocks_played_;
  if (blocks != blocks_at_feed_ && !dac_starved_) {
    blocks_at_feed_ = blocks;
    stm32f405::feed_watchdog();
  }
}

void HeadBoard::sleep() {
  cortex_m4::sleep_unless([this] { return link_.has_received(); });
}

std::uint64_t HeadBoard::now() {
  const InterruptsMasked masked;
  return count_.extend(TIM2->CNT);
}

// Triggers of the DAC up to this count; with each, the DMA has moved a code.
std::uint32_t HeadBoard::codes_at(std::uint64_t count) const {
  return static_cast<std::uint32_t>(count * head::kOversampling / counts_per_sample_);
}

void HeadBoard::on_codes() {
  DMA1->HIFCR = DMA_HIFCR_STREAM5;
  count_.advance(TIM2->CNT);
  contacts_.compare(closed_inputs());
  // The DMA may request the interrupt when it has read a block's last code, before the trigger that
  // needs it.
  constexpr std::uint32_t kEarly = 4;
  const std::uint32_t played = (codes_at(count_.now()) + kEarly) / kBlock;
  if (played != blocks_played_ + 1) {
    head_.fail(head::Fault::kHardware);  // an old block was played again
  }
  blocks_played_ = played;
  // The other half of the buffer is being played; this one follows it. A code is in the DAC's
  // holding register one trigger before it is at the output, and the first trigger found none.
  const std::uint32_t block = played + 1;
  const std::uint64_t first_code = std::uint64_t{block} * kBlock + 2;
  std::uint16_t codes[kBlock];
  head_.next_codes(first_code * counts_per_sample_ / head::kOversampling, codes, kBlock);
  volatile std::uint16_t* half = codes_ + block % 2 * kBlock;
  for (std::uint32_t i = 0; i < kBlock; ++i) {
    half[i] = codes[i];
  }
}

// The DAC takes no more codes from the DMA. The watchdog restarts the head.
void HeadBoard::on_dac_starved() {
  DAC->SR = DAC_SR_DMAUDR1;
  DAC->DHR12R1 = head::kMidScale;
  dac_starved_ = true;
  head_.fail(head::Fault::kHardware);
}

void HeadBoard::on_capture() {
  const std::uint32_t status = TIM2->SR;
  for (unsigned channel = 0; channel < head::kInputs; ++channel) {
    if ((status & TIM_SR_CCIF(channel)) == 0) {
      continue;
    }
    const std::uint64_t count = count_.extend(TIM2->CCR[channel]);  // clears the flag
    const bool lost = (status & TIM_SR_CCOF(channel)) != 0;
    if (lost) {
      TIM2->SR = ~TIM_SR_CCOF(channel);
    }
    contacts_.capture(channel, count > kFilter_counts ? count - kFilter_counts : 0, lost,
                      closed_inputs());
  }
}

}  // namespace gs::stm32f405
