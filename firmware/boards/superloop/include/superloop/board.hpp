// Interface between the loop and a board without an operating system.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/endpoint.hpp>

namespace gs::superloop {

// No call blocks. send() puts bytes into a buffer that an interrupt empties: all of them, or none
// if they do not fit.
class Board : public app::Carrier {
 public:
  // Takes up to `most` of the oldest samples; returns the number taken. `lost`: samples lost before
  // them.
  virtual std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) = 0;
  // The next byte from the link.
  virtual bool take_byte(std::uint8_t& byte) = 0;
  virtual void drive_relay(bool closed) = 0;
  virtual void feed_watchdog() = 0;
  // True if no sample is due, so that their absence is not a fault.
  virtual bool adc_idle() const = 0;

 protected:
  ~Board() = default;
};

}  // namespace gs::superloop
