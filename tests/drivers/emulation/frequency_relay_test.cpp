// The emulated contact-only device: when its contact opens, and when it must not.
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <emulation/frequency_relay.hpp>
#include <models/adc.hpp>

namespace gsbench::test {
namespace {

using emulation::FrequencyRelay;

constexpr double kRelayRate_hz = 8000.0;
constexpr double kRelayPi = 3.14159265358979323846;

struct Signal {
  std::function<double(double t_s)> frequency_hz;
  std::function<double(double t_s)> amplitude_pu = [](double) { return 1.0; };
  double noise_pu = 0.0;
};

// The time at which a relay with pick-up 49 Hz and 150 ms commands its contact to open.
std::optional<double> opens_s(const Signal& signal, double duration_s) {
  FrequencyRelay relay({49.0, 0.15}, 8000, 50, models::kCounts_per_pu);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1.0);
  double turns = 0.0;
  std::optional<double> opened_s;
  for (int n = 0; n < static_cast<int>(duration_s * kRelayRate_hz); ++n) {
    const double t_s = n / kRelayRate_hz;
    turns += signal.frequency_hz(t_s) / kRelayRate_hz;
    const double pu = signal.amplitude_pu(t_s) * std::cos(2.0 * kRelayPi * turns) +
                      signal.noise_pu * noise(random);
    const bool closed =
        relay.take(models::adc_counts(static_cast<float>(pu), models::kCounts_per_pu));
    if (!closed && !opened_s) {
      opened_s = t_s;
    }
    EXPECT_EQ(closed, !opened_s) << "the contact stays open, at " << t_s;
  }
  return opened_s;
}

double fifty_hz(double) {
  return 50.0;
}

TEST(FrequencyRelay, OpensAfterItsDelayBelowPickUp) {
  const auto opened_s = opens_s({[](double t_s) { return t_s < 1.0 ? 50.0 : 48.5; }}, 3.0);
  ASSERT_TRUE(opened_s);
  // The mean over five periods falls below 49 Hz after four of them at 48.5 Hz.
  EXPECT_GT(*opened_s, 1.0 + 0.15 + 3.0 / 48.5);
  EXPECT_LT(*opened_s, 1.0 + 0.15 + 6.0 / 48.5);
}

TEST(FrequencyRelay, OpensAtPickUpOnARamp) {
  // 49 Hz at 3 s.
  const auto opened_s = opens_s({[](double t_s) { return 50.5 - 0.5 * t_s; }}, 5.0);
  ASSERT_TRUE(opened_s);
  // The delay, plus half of five periods, plus up to one period until the next measurement.
  EXPECT_GT(*opened_s, 3.15 + 0.04);
  EXPECT_LT(*opened_s, 3.15 + 0.08);
}

TEST(FrequencyRelay, StaysClosedAbovePickUp) {
  EXPECT_FALSE(opens_s({[](double) { return 49.02; }}, 5.0));
}

TEST(FrequencyRelay, StaysClosedIfTheFrequencyRecoversWithinTheDelay) {
  const auto dip_of = [](double dip_s) {
    return Signal{[dip_s](double t_s) { return t_s > 1.0 && t_s < 1.0 + dip_s ? 48.0 : 50.0; }};
  };
  EXPECT_FALSE(opens_s(dip_of(0.14), 3.0));
  EXPECT_TRUE(opens_s(dip_of(0.26), 3.0));
}

TEST(FrequencyRelay, StaysClosedWithoutVoltageAndWhenItReturns) {
  for (const double level_pu : {0.0, 0.05, 0.6}) {
    const Signal dips = {
        fifty_hz, [level_pu](double t_s) { return std::fmod(t_s, 0.7) < 0.17 ? level_pu : 1.0; }};
    EXPECT_FALSE(opens_s(dips, 4.0)) << level_pu;
  }
}

TEST(FrequencyRelay, IsNotMisledByNoise) {
  EXPECT_FALSE(opens_s({[](double) { return 49.2; }, [](double) { return 1.0; }, 0.01}, 20.0));
}

}  // namespace
}  // namespace gsbench::test
