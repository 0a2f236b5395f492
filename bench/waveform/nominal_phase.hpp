// Phase of the nominal frequency at a tick, by integers only: it is as exact after a thousand hours
// as at the start.
#pragma once

#include <cmath>
#include <cstdint>

namespace gsbench::waveform {

class NominalPhase {
 public:
  // A double is mantissa·2^exponent: nominal/rate is a fraction of integers. nominal_hz >= 1.
  NominalPhase(double nominal_hz, std::int64_t sample_rate_hz) {
    int exponent = 0;
    const double mantissa = std::frexp(nominal_hz, &exponent);
    numerator_ = static_cast<std::uint64_t>(std::ldexp(mantissa, kMantissaBits));
    denominator_ = static_cast<Wide>(sample_rate_hz) << (kMantissaBits - exponent);
  }

  // Within [0, 1], rounded from the exact fraction of a cycle. tick >= 0.
  double cycles_at(std::int64_t tick) const {
    const Wide remainder = static_cast<Wide>(tick) * numerator_ % denominator_;
    return static_cast<double>(remainder) / static_cast<double>(denominator_);
  }

 private:
  using Wide = unsigned __int128;
  static constexpr int kMantissaBits = 53;

  Wide numerator_ = 0;    // < 2⁵³, so that the product with a tick fits in 128 bits
  Wide denominator_ = 1;  // < 2⁷³ for rates up to 1 MHz
};

}  // namespace gsbench::waveform
