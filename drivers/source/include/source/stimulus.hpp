// The signal that a source plays. The source pulls samples, or frequency and amplitude, from it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gsbench::source {

// White Gaussian noise. The source adds it, for each outlet separately if it can.
struct Noise {
  float rms_pu = 0.0F;  // per unit of nominal peak
  std::uint64_t seed = 0;
};

// A tick is one sample: 0 … total_ticks() − 1. All functions are pure and may be called from any
// thread.
class Stimulus {
 public:
  virtual ~Stimulus() = default;
  virtual std::int64_t sample_rate_hz() const = 0;
  virtual std::int64_t total_ticks() const = 0;
  virtual int nominal_hz() const = 0;
  virtual Noise noise() const = 0;
  // Frequency and amplitude are those of the fundamental. Phase steps, harmonics and offsets appear
  // in the samples only.
  virtual double frequency_hz(std::int64_t tick) const = 0;
  virtual double amplitude_pu(std::int64_t tick) const = 0;  // per unit of nominal peak
  // Writes samples first_tick … first_tick + count − 1, per unit of nominal peak, without noise.
  virtual void render(std::int64_t first_tick, std::size_t count, float* out) const = 0;
};

}  // namespace gsbench::source
