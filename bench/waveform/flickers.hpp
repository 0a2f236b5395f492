// The modulation of the amplitude by a signal's flicker.
#pragma once

#include <cstdint>
#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

class Flickers {
 public:
  Flickers(const std::vector<Flicker>& flickers, std::int64_t sample_rate_hz);

  bool is_on(std::int64_t from, std::int64_t end) const;
  double factor(std::int64_t tick) const;  // 1 without flicker
  // Multiplies samples from … end−1, less `offset`, by the factor; leaves them unchanged if it
  // is 1.
  void modulate(std::int64_t from, std::int64_t end, float offset, float* samples) const;

 private:
  struct Span {
    std::int64_t from_tick;
    std::int64_t end_tick;
    Flicker flicker;
  };

  std::vector<Span> spans_;
  double sample_rate_hz_;
};

}  // namespace gsbench::waveform
