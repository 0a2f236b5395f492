#include <grid_test/example_grids.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

TEST(SfrModel, HasTheParametersOfTheCalibratedIeee24BusSystem) {
  const SfrModel model(ieee24());
  EXPECT_NEAR(model.inertia_s(), 9.2161, kFourDecimals);
  EXPECT_NEAR(1.0 / model.droop_pu(), 21.8601, kFourDecimals);
  EXPECT_NEAR(model.omega_n(), 0.39723, kFiveDecimals);
  EXPECT_NEAR(model.zeta(), 0.75352, kFiveDecimals);
}

TEST(SfrModel, EqualsTheClosedFormOfThePaperIfUnderdamped) {
  const SfrModel model(ieee24());
  const double damping = model.zeta() * model.omega_n();
  // The paper's parameters to five decimals. Their rounding, times up to t = 10 s in ω_r·t, changes
  // the result by less than 1e-4 of the final value.
  const double alpha = 3.82075, omega_r = 0.26115, phi = -0.26481;
  for (double t_s = 0.0; t_s <= 10.0; t_s += 0.5) {
    const double eq6 = -model.gain_hz_per_mw() *
                       (1.0 + alpha * std::exp(-damping * t_s) * std::sin(omega_r * t_s + phi));
    EXPECT_NEAR(model.unit_deviation_hz(t_s), eq6, 1e-4 * model.gain_hz_per_mw()) << t_s;
  }
}

TEST(SfrModel, SettlesAtTheFinalValueOfEquation3) {
  const SfrModel model(ieee24());
  EXPECT_NEAR(50.0 + 500.0 * model.unit_deviation_hz(1000.0), 49.609, kThreeDecimals);
}

TEST(SfrModel, HasTheKnownResponseOfAnOverdampedGrid) {
  const SfrModel model(overdamped_grid());
  EXPECT_NEAR(model.zeta(), 1.14, 0.5e-2);
  EXPECT_NEAR(100.0 * model.unit_rocof_hz_s(0.0), -1.250, kThreeDecimals);
  EXPECT_NEAR(50.0 + 100.0 * model.unit_deviation_hz(1.45), 49.402, kThreeDecimals);
  EXPECT_NEAR(50.0 + 100.0 * model.unit_deviation_hz(1000.0), 49.750, kThreeDecimals);
}

TEST(SfrModel, IsAtRestBeforeTheLoss) {
  const SfrModel model(ieee24());
  for (const double t_s : {-1e-12, -1.0, -1e6}) {
    EXPECT_EQ(model.unit_deviation_hz(t_s), 0.0);
    EXPECT_EQ(model.unit_rocof_hz_s(t_s), 0.0);
    EXPECT_EQ(model.unit_phase_cycles(t_s), 0.0);
  }
}

TEST(SfrModel, HasAnInitialRocofThatDependsOnInertiaOnly) {
  const Grid grid = ieee24();
  const SfrModel model(grid);
  EXPECT_EQ(model.unit_deviation_hz(0.0), 0.0);
  EXPECT_EQ(model.unit_phase_cycles(0.0), 0.0);
  // Swing equation at t = 0: f_n/(2·H·S_B), independent of the governors.
  EXPECT_NEAR(model.unit_rocof_hz_s(0.0), -50.0 / (2.0 * 9.2160655737704923 * 2745.0), 1e-16);
}

TEST(SfrModel, DependsOnTheBaseOnlyThroughTheDamping) {
  Grid other = ieee24();
  other.base_mw = 1000.0;
  other.damping_pu *= 2745.0 / 1000.0;  // the same MW/Hz
  const SfrModel model(ieee24()), on_other_base(other);
  for (double t_s = 0.0; t_s < 30.0; t_s += 0.7) {
    EXPECT_NEAR(model.unit_deviation_hz(t_s), on_other_base.unit_deviation_hz(t_s),
                1e-13 * model.gain_hz_per_mw());
  }
}

TEST(SfrModel, HasTheDampingRatioOfTheExampleGrid) {
  for (const double zeta : {0.6, 0.999, 1.0, 1.001, 5.0}) {
    EXPECT_NEAR(SfrModel(grid_of_zeta(zeta)).zeta(), zeta, 1e-14);
  }
}

// At zeta = 1, rounding decides whether d is above, below or at zero: the three forms must agree. A
// response changes by about its own size per unit of zeta.
TEST(SfrModel, ChangesSmoothlyThroughCriticalDamping) {
  const SfrModel critical(grid_of_zeta(1.0));
  for (const double step : {1e-15, 1e-13, 1e-10, 1e-7, 1e-4}) {
    for (const double zeta : {1.0 - step, 1.0 + step}) {
      const SfrModel model(grid_of_zeta(zeta));
      const double size_hz = model.gain_hz_per_mw();
      const double tolerance = 10.0 * step + 1e-13;
      for (double t_s = 0.0; t_s < 20.0; t_s += 0.1) {
        ASSERT_NEAR(model.unit_deviation_hz(t_s), critical.unit_deviation_hz(t_s),
                    tolerance * size_hz)
            << zeta << ' ' << t_s;
        ASSERT_NEAR(model.unit_rocof_hz_s(t_s), critical.unit_rocof_hz_s(t_s),
                    tolerance * size_hz * model.initial_slope_per_s())
            << zeta << ' ' << t_s;
        ASSERT_NEAR(model.unit_phase_cycles(t_s), critical.unit_phase_cycles(t_s),
                    tolerance * size_hz * 20.0)
            << zeta << ' ' << t_s;
      }
    }
  }
}

class AnyDamping : public ::testing::TestWithParam<double> {
 protected:
  SfrModel model{grid_of_zeta(GetParam())};
};

// Five-point formulas: their error is h⁴/30 times the fifth derivative, which is at most the fifth
// power of the fastest rate. With h a thousandth of the fastest time constant it is below 1e-13,
// and a rounding of 1e-16 divided by h is 1e-12 of the value.
TEST_P(AnyDamping, HasRocofAndDeviationAsDerivativesOfDeviationAndPhase) {
  const double fastest = 2.0 * model.sigma_per_s() + model.initial_slope_per_s();
  const double h_s = 1e-3 / fastest;
  const double slope_hz_s = model.gain_hz_per_mw() * model.initial_slope_per_s();
  const auto slope = [h_s](auto&& of, double t_s) {
    return (8.0 * (of(t_s + h_s) - of(t_s - h_s)) - (of(t_s + 2.0 * h_s) - of(t_s - 2.0 * h_s))) /
           (12.0 * h_s);
  };
  for (double t_s = 3.0 * h_s; t_s < 20.0; t_s += 0.37) {
    EXPECT_NEAR(model.unit_rocof_hz_s(t_s),
                slope([this](double t) { return model.unit_deviation_hz(t); }, t_s),
                1e-11 * fastest * model.gain_hz_per_mw() + 1e-11 * slope_hz_s)
        << t_s;
    // The phase reaches 20 s times the deviation, and its rounding error as well.
    EXPECT_NEAR(model.unit_deviation_hz(t_s),
                slope([this](double t) { return model.unit_phase_cycles(t); }, t_s),
                1e-11 * fastest * 20.0 * model.gain_hz_per_mw())
        << t_s;
  }
}

TEST_P(AnyDamping, SettlesAndStaysFiniteUpTo1e9s) {
  for (const double t_s : {1e3, 1e5, 1e9}) {
    EXPECT_NEAR(model.unit_deviation_hz(t_s), -model.gain_hz_per_mw(),
                1e-15 * model.gain_hz_per_mw());
    EXPECT_NEAR(model.unit_rocof_hz_s(t_s), 0.0, 1e-15 * model.gain_hz_per_mw());
    EXPECT_NEAR(model.unit_phase_cycles(t_s), -model.gain_hz_per_mw() * t_s,
                model.gain_hz_per_mw() * 20.0);
  }
}

INSTANTIATE_TEST_SUITE_P(UnderCriticallyAndOverdamped, AnyDamping,
                         ::testing::Values(0.6, 0.75, 0.9999999, 1.0, 1.0000001, 1.14, 5.0, 40.0));

}  // namespace
}  // namespace gsbench::grid
