// An STM32F405 with a crystal of 8 MHz, such as Olimex's STM32-H405. Pins: PA1 the mains (0 … 3.3 V
// about 1.65 V), PA9 and PA10 the link's TX and RX, PC6 the relay's driver (high: closed).
#pragma once

#include "clocks.hpp"

#include <superloop/board.hpp>
#include <superloop/queues.hpp>

namespace gs::stm32f405 {

constexpr std::int32_t kSampleRate_hz = 8000;
// Of 2048 counts either way: the nominal peak comes to 1.1 V, with half as much again above it.
constexpr float kCounts_per_pu = 1365.0f;

class Stm32Board final : public superloop::Board {
 public:
  // At run time: as a constant, its buffers would be copied out of flash.
  Stm32Board();

  void start(const Clocks& clocks);
  void sleep();

  bool send(const std::uint8_t* bytes, std::size_t count) override;
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override;
  bool take_byte(std::uint8_t& byte) override;
  void drive_relay(bool closed) override;
  void feed_watchdog() override;
  bool adc_idle() const override { return false; }

  void on_usart();
  void on_samples();

 private:
  static constexpr std::uint32_t kBlock = 8;  // 1 ms

  void start_pins();
  void start_link(std::uint32_t apb2_hz);
  void start_adc(std::uint32_t timer_hz);
  void pump();

  superloop::ByteRing<512> received_;
  superloop::ByteRing<1024> to_send_;
  superloop::SampleQueue<256> samples_;
  volatile std::uint16_t converted_[2 * kBlock] = {};  // written by DMA, round and round
  std::uint32_t blocks_end_ = 0;                       // samples in blocks that were seen
};

// The independent watchdog caused this start. Told once.
bool watchdog_barked();
// From the chip's unique id; 0 where it is none of its kind.
std::uint32_t instance();

}  // namespace gs::stm32f405
