#include <grid_test/example_grids.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <grid/falling_limb.hpp>

namespace gsbench::grid {
namespace {

TEST(ClosedForm, HasThePapersParametersForTheIeee24BusSystem) {
  const SfrModel model(ieee24());
  const auto parameters = underdamped_parameters(model, 8.0);
  ASSERT_TRUE(parameters);
  EXPECT_NEAR(parameters->alpha, 3.82075, kFiveDecimals);
  EXPECT_NEAR(parameters->omega_r, 0.26115, kFiveDecimals);
  EXPECT_NEAR(parameters->phi1, 2.15938, kFiveDecimals);
  EXPECT_NEAR(parameters->phi, -0.26481, kFiveDecimals);
}

// α·sin(φ) = −1 makes eq. (6) start from zero; α·ω_n·sin(φ1) is the slope of eq. (16).
TEST(ClosedForm, HasParametersConsistentWithTheModelForEveryUnderdampedGrid) {
  for (double zeta = 0.6; zeta < 1.0; zeta += 0.05) {
    const SfrModel model(grid_of_zeta(zeta));
    const auto parameters = underdamped_parameters(model, 8.0);
    ASSERT_TRUE(parameters);
    EXPECT_NEAR(parameters->alpha * std::sin(parameters->phi), -1.0, 1e-12 * parameters->alpha);
    EXPECT_NEAR(parameters->alpha * model.omega_n() * std::sin(parameters->phi1),
                model.initial_slope_per_s(), 1e-12 * parameters->alpha);
    EXPECT_GT(parameters->phi1, 0.0);
    EXPECT_LT(parameters->phi1, M_PI);
  }
}

TEST(ClosedForm, HasNoParametersForAnOverdampedGrid) {
  EXPECT_FALSE(underdamped_parameters(SfrModel(overdamped_grid()), 8.0));
}

TEST(Nadir, HasTheKnownValueForTheIeee24BusSystem) {
  const Nadir lowest = nadir(SfrModel(ieee24()), 500.0);
  EXPECT_NEAR(lowest.t_s, 3.761, kThreeDecimals);
  EXPECT_NEAR(lowest.frequency_hz, 49.290, kThreeDecimals);
}

TEST(Nadir, HasTheKnownValueForAnOverdampedGrid) {
  const Nadir lowest = nadir(SfrModel(overdamped_grid()), 100.0);
  EXPECT_NEAR(lowest.t_s, 1.45, kTwoDecimals);
  EXPECT_NEAR(lowest.frequency_hz, 49.402, kThreeDecimals);
}

TEST(Nadir, ChangesSmoothlyThroughCriticalDamping) {
  const Nadir critical = nadir(SfrModel(grid_of_zeta(1.0)), 100.0);
  for (const double step : {1e-15, 1e-12, 1e-9, 1e-6}) {
    for (const double zeta : {1.0 - step, 1.0 + step}) {
      const Nadir lowest = nadir(SfrModel(grid_of_zeta(zeta)), 100.0);
      // Time and depth change by less than ten times their value per unit of zeta.
      EXPECT_NEAR(lowest.t_s, critical.t_s, critical.t_s * (10.0 * step + 1e-13)) << zeta;
      EXPECT_NEAR(lowest.frequency_hz, critical.frequency_hz, 10.0 * step + 1e-13) << zeta;
    }
  }
}

TEST(Nadir, IsTheFinalValueIfTheFrequencyHasNoMinimum) {
  const SfrModel model(first_order_grid());
  const Nadir lowest = nadir(model, 100.0);
  EXPECT_EQ(lowest.t_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(lowest.frequency_hz, 50.0 - 100.0 * model.gain_hz_per_mw());
}

// A slow prime mover with a short lag: both poles are slower than the zero at −1/T_R.
TEST(Nadir, IsTheFinalValueIfBothPolesAreSlowerThanTheReheat) {
  Grid grid = overdamped_grid();
  grid.damping_pu = 0.0;
  grid.gain_km = 0.1;
  grid.reheat_fraction = 0.0;
  grid.reheat_s = 1.0;
  grid.plants[0].inertia_s = 10.0;
  const SfrModel model(grid);
  ASSERT_GT(model.zeta(), 1.0);
  EXPECT_EQ(nadir(model, 100.0).t_s, std::numeric_limits<double>::infinity());
  EXPECT_LT(model.unit_rocof_hz_s(50.0), 0.0) << "still falling";
}

TEST(Nadir, IsProportionalToTheLoss) {
  const SfrModel model(ieee24());
  EXPECT_EQ(nadir(model, 0.0).frequency_hz, 50.0);
  EXPECT_NEAR(50.0 - nadir(model, 600.0).frequency_hz,
              6.0 * (50.0 - nadir(model, 100.0).frequency_hz), 1e-13);
}

TEST(Nadir, RefusesANegativeOrNaNLoss) {
  const SfrModel model(ieee24());
  EXPECT_THROW(nadir(model, -1.0), std::invalid_argument);
  EXPECT_THROW(nadir(model, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::grid
