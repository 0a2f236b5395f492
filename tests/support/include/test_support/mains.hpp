// A mains voltage for tests: nominal frequency for 1 s, then a linear fall if set.
#pragma once

#include <test_support/demand.hpp>

#include <cmath>
#include <cstdint>

#include <source/source.hpp>

namespace gsbench::test {

struct Mains : source::Stimulus {
  double duration_s = 60.0;
  double level_pu = 1.0;
  double falls_hz_s = 0.0;  // from 1 s on
  int harmonic = 50;        // its order, and its level of nominal peak
  double harmonic_pu = 0.0;
  source::Noise added;
  std::int64_t rate = 8000;
  int nominal = 50;

  double after_s(std::int64_t tick) const {
    return std::fmax(static_cast<double>(tick) / static_cast<double>(rate) - 1.0, 0.0);
  }

  std::int64_t sample_rate_hz() const override { return rate; }
  std::int64_t total_ticks() const override {
    return std::llround(duration_s * static_cast<double>(rate));
  }
  int nominal_hz() const override { return nominal; }
  source::Noise noise() const override { return added; }
  double frequency_hz(std::int64_t tick) const override {
    return nominal - falls_hz_s * after_s(tick);
  }
  double amplitude_pu(std::int64_t) const override { return level_pu; }
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    constexpr double kTau = 6.283185307179586;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t tick = first_tick + static_cast<std::int64_t>(i);
      const double cycles = static_cast<double>(nominal * tick % rate) / static_cast<double>(rate) -
                            0.5 * falls_hz_s * after_s(tick) * after_s(tick);
      const double angle_rad = kTau * (cycles - std::floor(cycles));
      out[i] = static_cast<float>(level_pu * std::cos(angle_rad) +
                                  harmonic_pu * std::cos(harmonic * angle_rad));
    }
  }
};

// Takes a source from off to the stimulus's tick 0. Throws std::runtime_error.
inline void start(source::Source& source, const source::Stimulus& stimulus) {
  demand(source.prepare(stimulus));
  demand(source.energise());
  demand(source.start());
}

inline void advance(source::Source& source, std::int64_t until_tick) {
  demand(source.advance(until_tick));
}

}  // namespace gsbench::test
