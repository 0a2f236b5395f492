// A plan's reference signal and samples follow its profile.
#include <profile_test/texts.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>

namespace gsbench::profile::test {
namespace {

TEST(Plan, GivesItsDurationInTicks) {
  EXPECT_EQ(parse(kMinimal).duration_ticks(), 48000);
  EXPECT_EQ(parse(kLossesInPlace).duration_ticks(), 40000);
}

TEST(Plan, FollowsTheResponseOfTheGridToLosses) {
  const Plan plan = parse(kLossesInPlace);
  const grid::SfrModel model(plan.grid);
  const auto reference = plan.reference();
  EXPECT_EQ(reference->frequency_hz(1.0), 60.0);
  // Two changes superposed, eq. (10); both sides are the same closed form, so only rounding
  // differs.
  EXPECT_NEAR(reference->frequency_hz(5.0),
              60.0 + 100.0 * model.unit_deviation_hz(3.0) - 50.0 * model.unit_deviation_hz(1.0),
              1e-12);
}

TEST(Plan, StaysAtNominalWithoutLosses) {
  const auto reference = parse(kMinimal).reference();
  EXPECT_EQ(reference->frequency_hz(0.0), 50.0);
  EXPECT_EQ(reference->frequency_hz(6.0), 50.0);
  EXPECT_EQ(reference->rocof_hz_s(3.0), 0.0);
}

TEST(Plan, HasTheFrequencyOfTheOutletsAndThatOfTheGridWithoutOscillations) {
  const Plan plan = parse(kDisturbed);
  const auto seen = plan.reference();
  const auto grid = plan.grid_reference();
  EXPECT_EQ(grid->frequency_hz(0.0), 49.85);
  EXPECT_EQ(grid->frequency_hz(1.9), 49.85);
  EXPECT_LT(grid->frequency_hz(9.0), 49.6);
  double most_hz = 0.0;
  for (double t_s = 1.0; t_s < 9.0; t_s += 0.01) {
    most_hz = std::max(most_hz, std::abs(seen->frequency_hz(t_s) - grid->frequency_hz(t_s)));
  }
  EXPECT_NEAR(most_hz, 0.070, 1e-3) << "the two amplitudes together";
  EXPECT_EQ(plan.synthesizer().reference().frequency_hz(2.5), seen->frequency_hz(2.5));
}

TEST(Plan, PassesThroughEachFrequencyPoint) {
  const auto reference = parse(kPoints).reference();
  EXPECT_EQ(reference->nominal_hz(), 50.0);
  EXPECT_NEAR(reference->frequency_hz(2.0), 49.5, 1e-12);  // rounding of a cubic
  EXPECT_NEAR(reference->frequency_hz(6.0), 49.8, 1e-12);
}

TEST(Plan, HasAConstantFrequencyWithOnePoint) {
  const Plan plan =
      parse(replaced(kPoints, "[[0.0, 50.0], [2.0, 49.5], [6.0, 49.8]]", "[[0.0, 47.5]]"));
  EXPECT_EQ(plan.reference()->frequency_hz(5.0), 47.5);
}

TEST(Plan, SynthesizesTheOffsetAndInitialPhaseOfTheProfile) {
  const Plan plan =
      parse(replaced(kMinimal, "6.0", "6.0\ndc_offset_pct = 25\ninitial_phase_deg = 90"));
  const waveform::Synthesizer synthesizer = plan.synthesizer();
  EXPECT_EQ(synthesizer.sample_rate_hz(), 8000);
  float first = 0.0F;
  synthesizer.render(0, 1, &first);
  // An extreme of the unit sine, without the offset; 1e-6 is above the rounding of float.
  EXPECT_NEAR(static_cast<double>(std::abs(first - 0.25F)), 1.0, 1e-6);
}

}  // namespace
}  // namespace gsbench::profile::test
