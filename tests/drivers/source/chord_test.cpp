// The distance between curves and straight lines, against the exact curves.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <source/chord.hpp>

namespace gsbench::source {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr std::int64_t kPeriod = 160;

// 50 Hz of amplitude 1 and a harmonic, at 8 kHz for 1 s.
std::vector<float> mains(int order = 1, double level = 0.0) {
  std::vector<float> samples(8000);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double turns = static_cast<double>(n) / static_cast<double>(kPeriod);
    samples[n] =
        static_cast<float>(std::cos(kTau * turns) + level * std::cos(kTau * (order * turns + 0.1)));
  }
  return samples;
}

double measured(const std::vector<float>& samples) {
  ChordMeter meter(kPeriod);
  meter.add(samples.data(), 11);
  meter.add(samples.data() + 11, samples.size() - 11);
  return meter.largest();
}

double of_sine(double level, int order) {
  return level * (1.0 - std::cos(0.5 * kTau * order / static_cast<double>(kPeriod)));
}

TEST(Chord, OfMainsIsExact) {
  EXPECT_NEAR(measured(mains()), of_sine(1.0, 1), 1e-6);
}

// The largest values of a harmonic need be neither at the middles nor at those of the fundamental.
TEST(Chord, OfAHarmonicIsNotTooLowAndAtMostATenthTooHigh) {
  for (const int order : {5, 13, 25, 40, 50}) {
    const double exact = of_sine(0.05, order);
    EXPECT_GT(measured(mains(order, 0.05)), 0.98 * exact) << order;
    EXPECT_LT(measured(mains(order, 0.05)), 1.10 * exact + of_sine(1.0, 1)) << order;
  }
}

TEST(Chord, IgnoresSteps) {
  std::vector<float> samples = mains(13, 0.02);
  const double without = measured(samples);
  for (const std::size_t from : {1000U, 1300U, 4444U}) {
    for (std::size_t n = from; n < samples.size(); ++n) {
      samples[n] *= 0.7F;
    }
  }
  EXPECT_NEAR(measured(samples), without, 1e-6);
}

}  // namespace
}  // namespace gsbench::source
