#include "example_truths.hpp"

#include <gmock/gmock.h>

namespace gsbench::waveform {
namespace {

TEST(LossTruth, IsTheFrequencyResponseOfTheGrid) {
  const grid::FrequencyResponse response(ieee24(), {{3.0, 500.0}, {4.0, -120.0}});
  const auto truth = truth_from_losses(ieee24(), {{3.0, 500.0}, {4.0, -120.0}});
  EXPECT_EQ(truth->nominal_hz(), 50.0);
  for (const double t_s : {0.0, 2.999, 3.0, 3.7, 4.0, 5.0, 60.0}) {
    EXPECT_EQ(truth->frequency_hz(t_s), response.frequency_hz(t_s));
    EXPECT_EQ(truth->rocof_hz_s(t_s), response.rocof_hz_s(t_s));
    EXPECT_EQ(truth->excess_cycles(t_s), response.excess_cycles(t_s));
    EXPECT_EQ(truth->voltage_pu(t_s), 1.0);
  }
}

TEST(LossTruth, HasACornerAtEachLossInOrderOfTime) {
  const auto truth = truth_from_losses(ieee24(), {{4.0, -120.0}, {3.0, 500.0}});
  EXPECT_THAT(truth->corners_s(), testing::ElementsAre(3.0, 4.0));
}

TEST(LossTruth, CountsPhaseFromZeroEvenAfterALossBeforeTheStart) {
  const auto truth = truth_from_losses(ieee24(), {{-2.0, 500.0}});
  EXPECT_EQ(truth->excess_cycles(0.0), 0.0);
  // Some 0.6 Hz below nominal by then; the trapezoid's error is 0.01²/12·|df/dt| < 2·10⁻⁶.
  EXPECT_NEAR(truth->excess_cycles(0.01),
              0.005 * (truth->frequency_hz(0.0) + truth->frequency_hz(0.01) - 100.0), 2e-6);
  EXPECT_LT(truth->frequency_hz(0.0), 49.5);
}

}  // namespace
}  // namespace gsbench::waveform
