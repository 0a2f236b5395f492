// From the samples of the stream to the codes of a 12-bit DAC: linear interpolation and noise
// shaping. Also used by the bench to compute what a head will play.
#pragma once

#include <cstdint>

#include <head/messages.hpp>

namespace gs::head {

constexpr std::uint16_t kMidScale = 2048;
// From −kLargestSample to kLargestSample no code overflows. A head accepts samples up to
// kFullScale.
constexpr std::int16_t kLargestSample = 2047 * 16;
static_assert(kFullScale <= kLargestSample);

class Interpolator {
 public:
  // `sample` is the first one.
  void begin(std::int16_t sample) {
    from_ = sample;
    to_ = sample;
    remainder_ = 0;
    phase_ = 0;
  }

  // True: the next code needs the sample after the last one.
  bool needs_sample() const { return phase_ == 1; }
  void add(std::int16_t sample) { to_ = sample; }

  // True: the next code is that of a sample itself.
  bool at_sample() const { return phase_ == 0; }

  // The next of the kOversampling codes of each sample, 1 … 4095. The remainder of the rounding is
  // added to the next code, so that the rounding errors of successive codes cancel: noise shaping
  // of first order, error(f) ∝ 2·sin(π·f/kCodeRate_hz).
  std::uint16_t next() {
    constexpr std::int32_t kPhases = kOversampling;
    constexpr std::int32_t kUnits = 16 * kPhases;  // in a step of the DAC
    constexpr std::int32_t kHalf = kUnits / 2;
    const std::int32_t wanted = from_ * (kPhases - phase_) + to_ * phase_ + remainder_;
    // Rounds to the nearest step; the offset keeps the division's operand positive.
    const std::int32_t code = (wanted + kHalf + kMidScale * kUnits) / kUnits;
    remainder_ = wanted - (code - kMidScale) * kUnits;
    if (++phase_ == kPhases) {
      phase_ = 0;
      from_ = to_;
    }
    return static_cast<std::uint16_t>(code);
  }

 private:
  std::int32_t from_ = 0;
  std::int32_t to_ = 0;
  std::int32_t remainder_ = 0;  // 1/128 steps, −64 … 63
  std::int32_t phase_ = 0;      // 0 … kOversampling − 1
};

}  // namespace gs::head
