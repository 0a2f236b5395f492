// Resampling, against the exact signals.
#include "resample.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <models/noise.hpp>

namespace gsbench::scpi {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kRate_hz = 8000.0;

std::vector<float> cosine(double frequency_hz, double level = 1.0) {
  std::vector<float> samples(4000);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] = static_cast<float>(
        level * std::cos(kTau * frequency_hz * static_cast<double>(n) / kRate_hz));
  }
  return samples;
}

// Largest error away from the ends, where samples are missing.
double worst_error(const std::vector<float>& in, double frequency_hz, double offset, double step,
                   double level = 1.0) {
  const auto count = static_cast<std::size_t>(3800.0 / step);
  const std::vector<float> out = resampled(in, offset, step, count);
  double worst = 0.0;
  for (auto n = static_cast<std::size_t>(200.0 / step); n < count; ++n) {
    const double at = offset + static_cast<double>(n) * step;
    const double exact = level * std::cos(kTau * frequency_hz * at / kRate_hz);
    worst = std::fmax(worst, std::fabs(static_cast<double>(out[n]) - exact));
  }
  return worst;
}

// A step of a DAC with 16 bits is 3e-5 of the amplitude.
constexpr double kWellBelowAStep = 1e-5;

TEST(Resampling, ToWholeMultiplesIsExactUpToTheFortiethHarmonic) {
  for (const double step : {1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0}) {
    for (const double frequency_hz : {0.0, 50.0, 150.0}) {
      EXPECT_LT(worst_error(cosine(frequency_hz), frequency_hz, 0.5 * step, step), kWellBelowAStep)
          << frequency_hz << " Hz, step " << step;
    }
    for (const double frequency_hz : {1000.0, 2000.0, 2400.0}) {
      EXPECT_LT(worst_error(cosine(frequency_hz, 0.02), frequency_hz, 0.5 * step, step, 0.02),
                kWellBelowAStep)
          << frequency_hz << " Hz, step " << step;
    }
  }
}

TEST(Resampling, DoesNotRingBesideAStep) {
  std::vector<float> in(4000, 0.0F);
  std::fill(in.begin() + 2000, in.end(), 1.0F);
  const std::vector<float> out = resampled(in, 0.125, 0.25, 15000);
  for (std::size_t n = 0; n < out.size(); ++n) {
    // In the middle between the samples, at 1999.5.
    EXPECT_NEAR(out[n], n < 7998 ? 0.0F : 1.0F, 1e-6F) << n;
  }
}

TEST(Resampling, OfNoiseKeepsItsPower) {
  std::vector<float> in(40000, 0.0F);
  models::add_gaussian({1, models::kSourceNoise, 0}, 0, in.size(), 0.05F, in.data());
  double squares = 0.0;
  const std::vector<float> out = band_limited(in, 0.0, 0.25, 150000);
  for (const float value : out) {
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  // The filter takes off the highest tenth of the band.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(out.size())), 0.0485, 0.0015);
}

TEST(Resampling, LeavesSamplesAsTheyAreWhereTheyMeet) {
  const std::vector<float> in = cosine(50.0);
  const std::vector<float> out = resampled(in, 0.0, 0.25, 16000);
  for (std::size_t n = 0; n < in.size(); ++n) {
    EXPECT_NEAR(out[4 * n], in[n], 1e-6F) << n;
  }
}

TEST(Resampling, ToAnyRateIsExactAtMainsFrequency) {
  for (const double step : {0.918273645, 1.234567, 3.21}) {
    EXPECT_LT(worst_error(cosine(50.0), 50.0, 0.0, step), kWellBelowAStep) << step;
  }
}

TEST(Resampling, RemovesWhatALowerRateCannotCarry) {
  // 2 kSa/s; 1.2 kHz would be seen at 800 Hz.
  EXPECT_LT(worst_error(cosine(1200.0), 1200.0, 0.0, 4.0, 0.0), 1e-4);
  EXPECT_LT(worst_error(cosine(700.0), 700.0, 0.0, 4.0), 1e-4);
}

}  // namespace
}  // namespace gsbench::scpi
