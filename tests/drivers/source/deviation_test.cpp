// DeviationMeter on sines whose deviation is known.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <source/deviation.hpp>

namespace gsbench::test {
namespace {

constexpr double kTurn_rad = 6.283185307179586;
constexpr std::int64_t kRate_hz = 8000;
constexpr double kDuration_s = 2.0;

std::vector<float> sine(double frequency_hz, double level_pu = 1.0) {
  std::vector<float> samples(static_cast<std::size_t>(kDuration_s * kRate_hz));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] = static_cast<float>(
        level_pu * std::cos(kTurn_rad * frequency_hz * static_cast<double>(n) / kRate_hz));
  }
  return samples;
}

source::Played deviation(const std::vector<float>& ideal, const std::vector<float>& played) {
  source::DeviationMeter meter(kRate_hz, 50);
  // In two parts, of which the first ends within a period.
  meter.add(ideal.data(), played.data(), 4321);
  meter.add(ideal.data() + 4321, played.data() + 4321, ideal.size() - 4321);
  return meter.largest();
}

TEST(DeviationMeter, FindsNoneBetweenEqualSignals) {
  const source::Played none = deviation(sine(49.3), sine(49.3));
  EXPECT_EQ(none.frequency_hz, 0.0);
  EXPECT_EQ(none.voltage_pu, 0.0);
}

TEST(DeviationMeter, FindsAFrequencyThatIsSlightlyOff) {
  for (const double nominal_hz : {50.0, 49.0, 51.5}) {
    const double found_hz = deviation(sine(nominal_hz), sine(nominal_hz + 0.001)).frequency_hz;
    // The image at the negative frequency leaves some per cent of the deviation.
    EXPECT_NEAR(found_hz, 0.001, 0.00005) << nominal_hz;
  }
}

TEST(DeviationMeter, ReportsTheLargestErrorOfASample) {
  std::vector<float> played = sine(50.0);
  played[7000] += 0.01F;
  EXPECT_NEAR(deviation(sine(50.0), played).voltage_pu, 0.01, 1e-6);
}

TEST(DeviationMeter, ShowsAPhaseStepAsFrequencyInItsWindow) {
  std::vector<float> played = sine(50.0);
  for (std::size_t n = 8000; n < played.size(); ++n) {
    played[n] =
        static_cast<float>(std::cos(kTurn_rad * 50.0 * static_cast<double>(n) / kRate_hz + 0.001));
  }
  // The slope of ten points with a step of 1 mrad in the middle: 12.5/82.5 mrad a period.
  EXPECT_NEAR(deviation(sine(50.0), played).frequency_hz, 0.001 * 12.5 / 82.5 / (kTurn_rad * 0.02),
              5e-5);
}

TEST(DeviationMeter, LeavesOutInterruptions) {
  std::vector<float> interrupted = sine(50.0);
  for (std::size_t n = 6000; n < 9000; ++n) {
    interrupted[n] = 0.0F;
  }
  EXPECT_LT(deviation(interrupted, interrupted).frequency_hz, 1e-9);
}

}  // namespace
}  // namespace gsbench::test
