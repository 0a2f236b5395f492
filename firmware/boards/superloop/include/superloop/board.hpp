// What a board without an operating system does for the loop.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/endpoint.hpp>

namespace gs::superloop {

// `send` puts bytes into a buffer that an interrupt empties: all of them, or none where it is full.
class Board : public app::Carrier {
 public:
  // Up to `most` of the oldest samples that were not taken; `lost` came before them and is gone.
  virtual std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) = 0;
  // The next byte from the link.
  virtual bool take_byte(std::uint8_t& byte) = 0;
  virtual void drive_relay(bool closed) = 0;
  virtual void feed_watchdog() = 0;
  // No sample is due, and that is no fault.
  virtual bool adc_idle() const = 0;

 protected:
  ~Board() = default;
};

}  // namespace gs::superloop
