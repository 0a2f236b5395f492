// A DAC head on the STM32F405 with an 8 MHz crystal. Pins: PA4 DAC; PA5, PA1, PA2, PA3 inputs 0 … 3
// (low: closed); PA9 and PA10 TX and RX of the link.
//
// One clock for all: timer 8 triggers the DAC, timer 2 counts and captures the inputs. Timer 2
// starts timer 8, so that the count of each code at the output is known exactly.
#pragma once

#include <stm32f405_chip/clocks.hpp>
#include <stm32f405_chip/usart_link.hpp>

#include <cstddef>
#include <cstdint>

#include <head/contacts.hpp>
#include <head/count64.hpp>
#include <head/head.hpp>
#include <wire/frame.hpp>

namespace gs::stm32f405 {

class HeadBoard {
 public:
  HeadBoard(const Clocks& clocks, const head::Hardware& hardware);

  void start();
  // Takes the received bytes and sends what is to be sent.
  void turn();
  // Until an interrupt.
  void sleep();

  void on_usart() { link_.on_interrupt(); }
  void on_codes();        // half of the DAC's buffer was played
  void on_dac_starved();  // the DMA was late
  void on_capture();

 private:
  static constexpr std::uint32_t kBlock = head::kCodeRate_hz / 1000;  // codes: 1 ms

  void start_dac();
  void start_inputs();
  void start_timers();
  std::uint32_t codes_at(std::uint64_t count) const;
  std::uint64_t now();
  void send_messages();
  void feed_watchdog();

  const Clocks clocks_;
  const std::uint32_t counts_per_sample_;
  head::Head head_;
  head::Contacts contacts_;
  head::Count64 count_;
  UsartLink link_;
  wire::FrameReader reader_;
  volatile std::uint16_t codes_[2 * kBlock] = {};  // circular DMA buffer
  volatile std::uint32_t blocks_played_ = 0;
  std::uint32_t blocks_at_feed_ = 0;
  volatile bool dac_starved_ = false;
};

}  // namespace gs::stm32f405
