// The ADC of an outlet on its own crystal.
#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

#include <models/crystal_adc.hpp>

namespace {

using gsbench::models::CrystalAdc;
using gsbench::models::kTest;
using gsbench::models::Stream;

constexpr double kRate_hz = 8000.0;
constexpr float kCounts_per_pu = 20000.0F;
constexpr double kPi = 3.14159265358979323846;

std::vector<float> sine(double frequency_hz, double amplitude_pu, std::size_t ticks) {
  std::vector<float> voltage(ticks);
  for (std::size_t n = 0; n < ticks; ++n) {
    voltage[n] = static_cast<float>(
        amplitude_pu * std::sin(2.0 * kPi * frequency_hz * static_cast<double>(n) / kRate_hz));
  }
  return voltage;
}

std::vector<std::int16_t> converted(const std::vector<float>& voltage, double ppm,
                                    std::size_t block, float noise_rms_pu = 0.0F) {
  CrystalAdc adc(ppm, kCounts_per_pu, noise_rms_pu, Stream{1, kTest, 0});
  std::vector<std::int16_t> samples;
  for (std::size_t at = 0; at < voltage.size(); at += block) {
    adc.take(voltage.data() + at, std::min(block, voltage.size() - at), samples);
  }
  return samples;
}

// Amplitude and phase of some samples at this frequency, with a Hann window, so that an incomplete
// period does not matter.
std::complex<double> correlation(const std::vector<std::int16_t>& samples, std::size_t from,
                                 std::size_t count, double frequency_hz) {
  std::complex<double> sum;
  for (std::size_t n = from; n < from + count; ++n) {
    const double part = static_cast<double>(n - from) / static_cast<double>(count);
    sum += (1.0 - std::cos(2.0 * kPi * part)) * static_cast<double>(samples[n]) *
           std::polar(1.0, -2.0 * kPi * frequency_hz * static_cast<double>(n) / kRate_hz);
  }
  return sum * (2.0 / static_cast<double>(count));
}

// Frequency in the outlet's own samples, from the phase difference between first and last second.
double measured_hz(const std::vector<std::int16_t>& samples, double about_hz) {
  const auto second = static_cast<std::size_t>(kRate_hz);
  const std::size_t last = samples.size() - second;
  const double turned = std::arg(correlation(samples, last, second, about_hz) /
                                 correlation(samples, 0, second, about_hz));
  return about_hz + turned / (2.0 * kPi) * kRate_hz / static_cast<double>(last);
}

class CrystalAdcAt : public testing::TestWithParam<double> {};

// A fast crystal takes more samples in the same time, so the mains frequency appears lower.
TEST_P(CrystalAdcAt, SeesTheMainsFrequencyRelativeToItsCrystal) {
  const double ppm = GetParam();
  const auto samples = converted(sine(50.0, 1.0, 80000), ppm, 128);
  // Rounding to counts of 1/20000 gives 1e-8 Hz over nine seconds; the single-precision position
  // between two samples gives less.
  EXPECT_NEAR(measured_hz(samples, 50.0), 50.0 / (1.0 + 1e-6 * ppm), 2e-7);
  // The last two source samples are kept for the next block.
  EXPECT_NEAR(static_cast<double>(samples.size()), (80000.0 - 2.0) * (1.0 + 1e-6 * ppm), 2.0);
}

INSTANTIATE_TEST_SUITE_P(Ppm, CrystalAdcAt, testing::Values(-1000.0, -60.0, 0.0, 200.0));

TEST(CrystalAdc, InterpolatesHarmonicsCorrectly) {
  const auto samples = converted(sine(500.0, 1.0, 80000), 200.0, 128);
  const double amplitude = std::abs(correlation(samples, 0, 40000, 500.0 / 1.0002));
  // At a sixteenth of the sampling rate, a cubic is 3e-4 too low in the middle between two samples
  // and exact at the samples; the drift passes through all positions.
  EXPECT_NEAR(amplitude / static_cast<double>(kCounts_per_pu), 1.0, 5e-4);
}

TEST(CrystalAdc, DoesNotDependOnTheBlocks) {
  const auto voltage = sine(50.0, 1.0, 20000);
  const auto once = converted(voltage, 200.0, voltage.size(), 0.01F);
  EXPECT_EQ(converted(voltage, 200.0, 1, 0.01F), once);
  EXPECT_EQ(converted(voltage, 200.0, 37, 0.01F), once);
  EXPECT_EQ(converted(voltage, 200.0, 128, 0.01F), once);
}

TEST(CrystalAdc, TakesTheSamplesOfTheSourceWithAnExactCrystal) {
  const auto voltage = sine(50.0, 1.0, 1000);
  const auto samples = converted(voltage, 0.0, 100);
  ASSERT_EQ(samples.size(), 998U);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    ASSERT_EQ(samples[n], std::lround(voltage[n] * kCounts_per_pu)) << n;
  }
}

TEST(CrystalAdc, AddsNoiseOfTheGivenRms) {
  constexpr double kRms_pu = 0.01;
  constexpr std::size_t kTicks = 80000;
  const auto samples =
      converted(std::vector<float>(kTicks), 200.0, 128, static_cast<float>(kRms_pu));
  double squares = 0.0;
  for (const std::int16_t sample : samples) {
    squares += static_cast<double>(sample) * sample;
  }
  const double rms_pu = std::sqrt(squares / static_cast<double>(samples.size())) / 20000.0;
  // Five standard deviations of an RMS from 80 000 values: 5/√(2 · 80 000) = 1.25 %.
  EXPECT_NEAR(rms_pu, kRms_pu, 0.0125 * kRms_pu);
}

TEST(CrystalAdc, SaturatesAtFullScale) {
  const auto samples = converted({2.0F, 2.0F, 2.0F, 2.0F, -2.0F, -2.0F, -2.0F, -2.0F}, 0.0, 8);
  ASSERT_EQ(samples.size(), 6U);
  EXPECT_EQ(samples.front(), 32767);
  EXPECT_EQ(samples.back(), -32768);
}

}  // namespace
