// The tones of a signal, each a sine of a constant frequency of its own.
#pragma once

#include <cstdint>
#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

class Tones {
 public:
  Tones(const std::vector<Tone>& tones, std::int64_t sample_rate_hz);

  // Adds the tones to samples from … end−1 of the block that begins with block_tick. Samples are
  // computed from the block's start, so that they do not depend on `from` and `end`.
  void add(std::int64_t block_tick, std::int64_t from, std::int64_t end, float* out) const;

 private:
  struct Span {
    std::int64_t from_tick;
    std::int64_t end_tick;
    double at_s;
    double frequency_hz;
    double amplitude_pu;
    double phase_cycles;  // at at_s
  };

  std::vector<Span> spans_;
  double sample_rate_hz_;
};

}  // namespace gsbench::waveform
