// STM32F405 with an 8 MHz crystal, such as Olimex's STM32-H405. Pins: PA1 mains (0 … 3.3 V around
// 1.65 V), PA9 and PA10 TX and RX of the link, PC6 relay driver (high: closed).
#pragma once

#include <stm32f405_chip/clocks.hpp>
#include <stm32f405_chip/usart_link.hpp>

#include <queues/queues.hpp>

#include <superloop/board.hpp>

namespace gs::stm32f405 {

constexpr std::int32_t kSampleRate_hz = 8000;
// Full scale is ± 2048 counts, 1.65 V. The nominal peak is 1.1 V; 50 % headroom.
constexpr float kCounts_per_pu = 1365.0f;

class Stm32Board final : public superloop::Board {
 public:
  // Not constexpr. Otherwise the compiler would put the object's initial value, with all buffers,
  // into flash.
  Stm32Board();

  void start(const Clocks& clocks);
  void sleep();

  bool send(const std::uint8_t* bytes, std::size_t count) override;
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override;
  bool take_byte(std::uint8_t& byte) override;
  void drive_relay(bool closed) override;
  void feed_watchdog() override;
  bool adc_idle() const override { return false; }

  void on_usart() { link_.on_interrupt(); }
  void on_samples();

 private:
  static constexpr std::uint32_t kBlock = 8;  // 1 ms

  void start_pins();
  void start_adc(std::uint32_t timer_hz);

  UsartLink link_;
  queues::SampleQueue<256> samples_;
  volatile std::uint16_t converted_[2 * kBlock] = {};  // circular DMA buffer
  std::uint32_t blocks_end_ = 0;                       // sample count at the end of the last block
};

// CRC-32 of the chip's unique id; 0 on any other chip.
std::uint32_t instance();

}  // namespace gs::stm32f405
