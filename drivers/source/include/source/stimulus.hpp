// What a source plays, from its first tick to its last. The source pulls from it what it needs:
// samples, or frequency and amplitude.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gsbench::source {

// White, Gaussian; added by the source, which may have a channel for each outlet.
struct Noise {
  float rms_pu = 0.0F;  // per unit of nominal peak
  std::uint64_t seed = 0;
};

// Ticks are 0 … total_ticks() − 1 throughout. Pure: the same tick gives the same value, on any
// thread.
class Stimulus {
 public:
  virtual ~Stimulus() = default;
  virtual std::int64_t sample_rate_hz() const = 0;
  virtual std::int64_t total_ticks() const = 0;
  virtual int nominal_hz() const = 0;
  virtual Noise noise() const = 0;
  // Of the fundamental; phase jumps, harmonics and offsets are in the samples alone.
  virtual double frequency_hz(std::int64_t tick) const = 0;
  virtual double amplitude_pu(std::int64_t tick) const = 0;
  // Samples first_tick … first_tick + count − 1, per unit of nominal peak, without the noise.
  virtual void render(std::int64_t first_tick, std::size_t count, float* out) const = 0;
};

}  // namespace gsbench::source
