#include <grid_test/example_grids.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

double lowest_hz(const FrequencyResponse& response) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int ms = 0; ms <= 20'000; ++ms) {
    lowest = std::min(lowest, response.frequency_hz(1e-3 * ms));
  }
  return lowest;
}

TEST(FrequencyResponse, IsNominalBeforeTheFirstChange) {
  const FrequencyResponse response(SfrModel(ieee24()), {{3.0, 500.0}, {4.0, -100.0}});
  EXPECT_EQ(response.frequency_hz(2.999999), 50.0);
  EXPECT_EQ(response.rocof_hz_s(2.999999), 0.0);
  EXPECT_EQ(response.excess_cycles(2.999999), 0.0);
  EXPECT_LT(response.rocof_hz_s(3.0), 0.0);
}

TEST(FrequencyResponse, IsAlwaysNominalWithoutAChange) {
  const FrequencyResponse response(SfrModel(ieee24()), {});
  EXPECT_EQ(response.frequency_hz(5.0), 50.0);
  EXPECT_EQ(response.rocof_hz_s(5.0), 0.0);
  EXPECT_EQ(response.excess_cycles(5.0), 0.0);
}

TEST(FrequencyResponse, HasTheKnownNadirAndFinalValueForALossOf500Mw) {
  const FrequencyResponse response(SfrModel(ieee24()), {{0.0, 500.0}});
  EXPECT_NEAR(lowest_hz(response), 49.290, 0.5e-3);
  EXPECT_NEAR(response.frequency_hz(1000.0), 49.609, 0.5e-3);
}

TEST(FrequencyResponse, SuperposesChanges) {
  const SfrModel model(ieee24());
  const FrequencyResponse one(model, {{1.0, 500.0}}), other(model, {{1.7, -148.0}});
  const FrequencyResponse both(model, {{1.7, -148.0}, {1.0, 500.0}});
  for (double t_s = 0.0; t_s < 10.0; t_s += 0.1) {
    // One rounding of 50 Hz per sum.
    EXPECT_NEAR(both.frequency_hz(t_s), one.frequency_hz(t_s) + other.frequency_hz(t_s) - 50.0,
                3e-14);
    EXPECT_NEAR(both.rocof_hz_s(t_s), one.rocof_hz_s(t_s) + other.rocof_hz_s(t_s), 1e-15);
    EXPECT_NEAR(both.excess_cycles(t_s), one.excess_cycles(t_s) + other.excess_cycles(t_s), 1e-14);
  }
}

TEST(FrequencyResponse, FallsDeeperAfterALargerLoss) {
  const SfrModel model(overdamped_grid());
  for (double t_s = 0.1; t_s < 10.0; t_s += 0.1) {
    double before_hz = 50.0;
    for (double loss_mw = 20.0; loss_mw <= 200.0; loss_mw += 20.0) {
      const double hz = FrequencyResponse(model, {{0.0, loss_mw}}).frequency_hz(t_s);
      EXPECT_LT(hz, before_hz);
      before_hz = hz;
    }
  }
}

// 148.34 MW: the power that the paper's million outlets shed after a loss of 500 MW (§6.5).
TEST(FrequencyResponse, HasALowerNadirTheLaterTheShedding) {
  for (const auto& [delay_s, expected_hz] :
       std::map<double, double>{{0.0, 49.5004}, {0.64, 49.4948}, {0.96, 49.4860}, {1.2, 49.4754}}) {
    const FrequencyResponse response(SfrModel(ieee24()), {{0.0, 500.0}, {delay_s, -148.34}});
    EXPECT_NEAR(lowest_hz(response), expected_hz, 0.5e-4) << delay_s;
  }
}

// 92 MW have this final deviation in this grid.
TEST(FrequencyResponse, StartsFromAnEquilibriumAsIfPowerHadBeenLostLongBefore) {
  const SfrModel model(ieee24());
  const double before_mw = 0.072 / model.gain_hz_per_mw();
  EXPECT_NEAR(before_mw, 92.0, 0.05);
  const FrequencyResponse response(model, {{2.0, 300.0}}, -0.072);
  const FrequencyResponse long_before(model, {{-1000.0, before_mw}, {2.0, 300.0}});
  EXPECT_EQ(response.frequency_hz(0.0), 49.928);
  EXPECT_EQ(response.rocof_hz_s(1.9), 0.0);
  for (double t_s = 0.0; t_s < 10.0; t_s += 0.1) {
    EXPECT_NEAR(response.frequency_hz(t_s), long_before.frequency_hz(t_s), 3e-14);
    EXPECT_NEAR(response.rocof_hz_s(t_s), long_before.rocof_hz_s(t_s), 1e-15);
    EXPECT_NEAR(response.excess_cycles(t_s),
                long_before.excess_cycles(t_s) - long_before.excess_cycles(0.0), 1e-13);
  }
  EXPECT_LT(response.frequency_hz(5.0), 49.6);
}

TEST(FrequencyResponse, RefusesAChangeThatIsNotFinite) {
  const SfrModel model(ieee24());
  const double nan = std::nan("");
  EXPECT_THROW(FrequencyResponse(model, {{nan, 500.0}}), std::invalid_argument);
  EXPECT_THROW(FrequencyResponse(model, {{0.0, nan}}), std::invalid_argument);
  EXPECT_THROW(FrequencyResponse(model, {{0.0, 500.0}, {HUGE_VAL, 1.0}}), std::invalid_argument);
  EXPECT_THROW(FrequencyResponse(model, {{0.0, 500.0, -0.1}}), std::invalid_argument);
  EXPECT_THROW(FrequencyResponse(model, {{0.0, 500.0, nan}}), std::invalid_argument);
  EXPECT_THROW(FrequencyResponse(model, {}, nan), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::grid
