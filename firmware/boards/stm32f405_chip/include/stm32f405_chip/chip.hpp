// Pins, unique id, reset and watchdog of the STM32F405.
#pragma once

#include <stm32f405_chip/rm0090.hpp>

#include <cstddef>
#include <cstdint>

namespace gs::stm32f405 {

constexpr std::size_t kUniqueIdBytes = 12;

void set_mode(Gpio& port, unsigned pin, std::uint32_t mode);
// Alternate function 0 … 15 (datasheet, alternate function mapping).
void set_function(Gpio& port, unsigned pin, std::uint32_t function);
void pull_up(Gpio& port, unsigned pin);

// True if the independent watchdog caused this start; true only for the first call.
bool reset_by_watchdog();
// Starts the independent watchdog: it resets after `ticks` of 32 kHz / 4 · 2^prescaler, and its
// clock is between 17 kHz and 47 kHz (datasheet, LSI oscillator characteristics). Feed it in time.
void start_watchdog(std::uint32_t prescaler, std::uint32_t ticks);
inline void feed_watchdog() {
  IWDG->KR = IWDG_KR_FEED;
}

// A number from the random number generator; 0 if its clock does not run. Takes up to 0.1 ms.
std::uint32_t random_number();

// The chip's unique id; zeros on any other chip.
void read_unique_id(std::uint8_t (&id)[kUniqueIdBytes]);

}  // namespace gs::stm32f405
