// The fundamental of stimuli whose phase and amplitude are known.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <source/fundamental.hpp>

namespace gsbench::test {
namespace {

constexpr double kTurn = 6.283185307179586;

// 1 s with a straight course of frequency.
class Falling final : public source::Stimulus {
 public:
  Falling(int nominal_hz, double slope_hz_s, double amplitude_pu, double fifth_pu)
      : nominal_hz_(nominal_hz), slope_(slope_hz_s), amplitude_(amplitude_pu), fifth_(fifth_pu) {}
  std::int64_t sample_rate_hz() const override { return 8000; }
  std::int64_t total_ticks() const override { return 8000; }
  int nominal_hz() const override { return nominal_hz_; }
  source::Noise noise() const override { return {}; }
  double frequency_hz(std::int64_t tick) const override {
    return nominal_hz_ + slope_ * static_cast<double>(tick) / 8000.0;
  }
  double amplitude_pu(std::int64_t) const override { return amplitude_; }
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    for (std::size_t n = 0; n < count; ++n) {
      const std::int64_t tick = first_tick + static_cast<std::int64_t>(n);
      out[n] = static_cast<float>(
          amplitude_ * std::cos(phase_rad(tick)) +
          fifth_ * std::cos(5.0 * kTurn * nominal_hz_ * static_cast<double>(tick) / 8000.0));
    }
  }
  double phase_rad(std::int64_t tick) const {
    const double time_s = static_cast<double>(tick) / 8000.0;
    return 0.7 + kTurn * (nominal_hz_ + 0.5 * slope_ * time_s) * time_s;
  }

 private:
  int nominal_hz_;
  double slope_;
  double amplitude_;
  double fifth_;
};

// Amplitude and phase, radians, that are found beyond those of the stimulus.
std::pair<double, double> off(const Falling& stimulus, std::int64_t tick) {
  const std::complex<double> found = source::fundamental_pu(stimulus, tick);
  return {std::abs(found) - stimulus.amplitude_pu(tick),
          std::remainder(std::arg(found) - stimulus.phase_rad(tick), kTurn)};
}

TEST(Fundamental, HasAmplitudeAndPhaseOfAFallingFrequencyAtBothEnds) {
  for (const int nominal_hz : {50, 60}) {
    const Falling stimulus(nominal_hz, -1.0, 0.8, 0.0);
    for (const std::int64_t tick : {0, 100, 4000, 8000}) {
      const auto [amplitude_pu, phase_rad] = off(stimulus, tick);
      EXPECT_NEAR(amplitude_pu, 0.0, 1e-6) << nominal_hz << " Hz, tick " << tick;
      // Up to 400 steps, each with the frequency of its beginning: 0.025 mrad by 1 Hz/s.
      EXPECT_NEAR(phase_rad, 0.0, 3e-5) << nominal_hz << " Hz, tick " << tick;
    }
  }
}

TEST(Fundamental, IsNotChangedByAHarmonicOfNominalFrequency) {
  for (const int nominal_hz : {50, 60}) {
    const auto [amplitude_pu, phase_rad] = off(Falling(nominal_hz, 0.0, 1.0, 0.1), 8000);
    EXPECT_NEAR(amplitude_pu, 0.0, 1e-6);
    EXPECT_NEAR(phase_rad, 0.0, 1e-6);
  }
}

TEST(Fundamental, OfADeadBusIs0) {
  EXPECT_EQ(source::fundamental_pu(Falling(50, 0.0, 0.0, 0.0), 0), 0.0);
}

TEST(Soft, RisesFrom0To1WithItsMiddleAtOneHalf) {
  EXPECT_EQ(source::soft(-0.1), 0.0);
  EXPECT_NEAR(source::soft(0.25), 0.5 - std::sqrt(0.125), 1e-12);
  EXPECT_NEAR(source::soft(0.5), 0.5, 1e-12);
  EXPECT_EQ(source::soft(1.1), 1.0);
}

}  // namespace
}  // namespace gsbench::test
