#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

#include <head/interpolator.hpp>

namespace gs::head {
namespace {

std::vector<std::uint16_t> codes_of(const std::vector<std::int16_t>& samples) {
  Interpolator interpolator;
  interpolator.begin(samples.at(0));
  std::vector<std::uint16_t> codes;
  for (std::size_t next = 1;;) {
    if (interpolator.needs_sample()) {
      if (next == samples.size()) {
        return codes;
      }
      interpolator.add(samples[next++]);
    }
    codes.push_back(interpolator.next());
  }
}

TEST(Interpolator, PlaysStraightLinesBetweenSamples) {
  const std::vector<std::uint16_t> expected = {2048, 2050, 2052, 2054, 2056, 2058, 2060, 2062, 2064,
                                               2063, 2062, 2061, 2060, 2059, 2058, 2057, 2056};
  EXPECT_EQ(codes_of({0, 256, 128}), expected);
}

TEST(Interpolator, PlaysMidScaleForZero) {
  for (const std::uint16_t code : codes_of(std::vector<std::int16_t>(100, 0))) {
    ASSERT_EQ(code, kMidScale);
  }
}

TEST(Interpolator, StaysInTheRangeOfTheDac) {
  const std::int16_t most = kLargestSample;
  const std::int16_t least = -kLargestSample;
  for (const std::uint16_t code : codes_of({most, most, least, least, most, 32751, -32745, most})) {
    ASSERT_GE(code, 1);
    ASSERT_LE(code, 4095);
  }
  EXPECT_EQ(codes_of({most, most}).front(), 4095);
  EXPECT_EQ(codes_of({least, least}).front(), 1);
}

TEST(Interpolator, PlaysTheFractionOfAStepOnAverage) {
  const auto codes = codes_of(std::vector<std::int16_t>(1000, 5));
  double sum = 0.0;
  for (const std::uint16_t code : codes) {
    sum += code - kMidScale;
  }
  EXPECT_NEAR(sum / static_cast<double>(codes.size()), 5.0 / 16.0, 1e-3);
}

// Amplitude of the rounding error at a frequency, in steps of the DAC, for a sine of 50 Hz.
double rounding_error_at(double frequency_hz) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr std::size_t kSamples = 8000;
  std::vector<std::int16_t> samples;
  for (std::size_t i = 0; i <= kSamples; ++i) {
    const double phase = 2.0 * kPi * 50.02 * static_cast<double>(i) / kSampleRate_hz;
    samples.push_back(static_cast<std::int16_t>(std::lround(28000.0 * std::sin(phase))));
  }
  const auto codes = codes_of(samples);
  std::complex<double> sum;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto part = static_cast<double>(i % kOversampling) / kOversampling;
    const double exact = samples[i / kOversampling] * (1.0 - part) +
                         samples[std::min(i / kOversampling + 1, kSamples)] * part;
    const double window =
        1.0 - std::cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(codes.size()));
    sum += window * (codes[i] - kMidScale - exact / 16.0) *
           std::polar(1.0, -2.0 * kPi * frequency_hz * static_cast<double>(i) / kCodeRate_hz);
  }
  return 2.0 * std::abs(sum) / static_cast<double>(codes.size());
}

// Without noise shaping the error would be that of white noise everywhere: 2e-3 steps.
TEST(Interpolator, LeavesHardlyAnyRoundingErrorNearTheMainsFrequency) {
  double near_mains = 0.0;
  double near_code_rate = 0.0;
  for (int i = 0; i < 20; ++i) {
    near_mains = std::max(near_mains, rounding_error_at(40.0 + i));
    near_code_rate = std::max(near_code_rate, rounding_error_at(20040.0 + 61.0 * i));
  }
  EXPECT_LT(near_mains, 1e-4);
  EXPECT_GT(near_code_rate, 1e-3);
}

}  // namespace
}  // namespace gs::head
