// Interface between the loop and a board without an operating system.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/endpoint.hpp>

namespace gs::superloop {

// No call blocks. send() puts the bytes into a buffer, from which an interrupt sends them. If they
// do not all fit, it takes none and returns false.
class Board : public app::Carrier {
 public:
  // Takes up to `most` of the oldest samples and returns the number taken. Sets `lost` to the
  // number of samples lost before them.
  virtual std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) = 0;
  // Takes the next byte from the link. Returns false if there is none.
  virtual bool take_byte(std::uint8_t& byte) = 0;
  virtual void drive_relay(bool closed) = 0;
  virtual void feed_watchdog() = 0;
  // True if no sample is due. The loop then feeds the watchdog although it has taken no samples.
  virtual bool adc_idle() const = 0;

 protected:
  ~Board() = default;
};

}  // namespace gs::superloop
