// What a clairvoyant sheds, compared with a search in small steps.
#include <test_support/ieee24.hpp>

#include <gtest/gtest.h>

#include <fleet/clairvoyant.hpp>

namespace gsbench::fleet {
namespace {

constexpr double kGoal_hz = -0.5;
constexpr double kFleet_mw = 905.0;

const grid::SfrModel& model() {
  static const grid::SfrModel model(test::ieee24());
  return model;
}

// The state `after_s` after a loss of loss_mw.
GridState after_loss(double loss_mw, double after_s) {
  return later(model(), with_power(model(), {}, loss_mw), after_s);
}

double lowest_by_steps_hz(GridState state) {
  double lowest_hz = state.deviation_hz;
  for (int i = 0; i < 1500; ++i) {
    state = later(model(), state, 0.01);
    lowest_hz = std::min(lowest_hz, state.deviation_hz);
  }
  return lowest_hz;
}

// In steps of 0.25 MW.
double least_by_steps_mw(const GridState& state, double available_mw) {
  const auto nadir_hz = [&](double shed_mw) {
    return lowest_by_steps_hz(with_power(model(), state, state.power_mw - shed_mw));
  };
  const double most_mw = std::min(available_mw, state.power_mw);
  const double reach_hz = std::min(kGoal_hz, nadir_hz(most_mw) - 0.01);
  double shed_mw = 0.0;
  while (shed_mw < most_mw && nadir_hz(shed_mw) < reach_hz) {
    shed_mw += 0.25;
  }
  return shed_mw;
}

TEST(Clairvoyant, ShedsTheLeastPowerThatKeepsTheThreshold) {
  for (const double loss_mw : {300.0, 360.0, 500.0, 700.0}) {
    for (const double after_s : {0.0, 0.5, 0.96}) {
      const GridState state = after_loss(loss_mw, after_s);
      const double shed_mw = least_shed_mw(model(), state, kGoal_hz, kFleet_mw);
      EXPECT_NEAR(shed_mw, least_by_steps_mw(state, kFleet_mw), 0.26) << loss_mw << ' ' << after_s;
    }
  }
  EXPECT_EQ(least_shed_mw(model(), after_loss(300.0, 0.5), kGoal_hz, kFleet_mw), 0.0);
  EXPECT_NEAR(least_shed_mw(model(), after_loss(500.0, 0.0), kGoal_hz, kFleet_mw), 148.08, 0.01);
}

// 900 MW fall below f_s within 1.2 s.
TEST(Clairvoyant, StaysWithinTenMillihertzOfTheBestIfTheThresholdIsOutOfReach) {
  for (const double after_s : {1.1, 1.5, 2.5}) {
    const GridState state = after_loss(900.0, after_s);
    const double shed_mw = least_shed_mw(model(), state, kGoal_hz, kFleet_mw);
    EXPECT_NEAR(shed_mw, least_by_steps_mw(state, kFleet_mw), 0.26) << after_s;
    EXPECT_LT(shed_mw, 500.0);  // the rest would raise the nadir by 10 mHz
    EXPECT_GT(shed_mw, 100.0);
  }
}

TEST(Clairvoyant, ShedsNoMoreThanThereIs) {
  const GridState state = after_loss(900.0, 0.5);
  const double shed_mw = least_shed_mw(model(), state, kGoal_hz, 100.0);
  EXPECT_NEAR(shed_mw, least_by_steps_mw(state, 100.0), 0.26);
  EXPECT_GT(shed_mw, 80.0);
  EXPECT_LE(shed_mw, 100.0);
}

TEST(Clairvoyant, ShedsNothingIfNothingIsLost) {
  EXPECT_EQ(least_shed_mw(model(), {-0.7, -0.2, 0.0, 0.0}, kGoal_hz, kFleet_mw), 0.0);
  EXPECT_EQ(least_shed_mw(model(), {-0.7, -0.2, -50.0, 0.0}, kGoal_hz, kFleet_mw), 0.0);
}

TEST(Clairvoyant, KnowsALossLateAndAReturnAtOnce) {
  const std::vector<grid::PowerChange> losses = {{2.0, 500.0}, {3.0, -300.0}, {3.2, 600.0}};
  EXPECT_EQ(known_loss_mw(losses, 2.29, 0.3), 0.0);
  EXPECT_EQ(known_loss_mw(losses, 2.31, 0.3), 500.0);
  EXPECT_EQ(known_loss_mw(losses, 3.0, 0.3), 200.0);
  EXPECT_EQ(known_loss_mw(losses, 3.49, 0.3), 200.0);
  EXPECT_EQ(known_loss_mw(losses, 3.51, 0.3), 800.0);
  // A loss that comes back before it is known is never known.
  EXPECT_EQ(known_loss_mw({{2.0, 500.0}, {2.2, -500.0}}, 2.4, 0.3), 0.0);
}

TEST(Clairvoyant, KnowsARampLateWhenItFallsAndAtOnceWhenItReturns) {
  const std::vector<grid::PowerChange> losses = {{2.0, 500.0, 1.0}, {5.0, -500.0, 1.0}};
  EXPECT_NEAR(known_loss_mw(losses, 2.5, 0.3), 100.0, 1e-9);
  EXPECT_NEAR(known_loss_mw(losses, 4.0, 0.3), 500.0, 1e-9);
  EXPECT_NEAR(known_loss_mw(losses, 5.5, 0.3), 250.0, 1e-9);
  // A loss while another one returns: known is the least, just before it.
  EXPECT_NEAR(known_loss_mw({{0.0, 500.0}, {2.0, -400.0, 1.0}, {2.5, 300.0}}, 2.6, 0.3), 300.0,
              1e-6);
}

}  // namespace
}  // namespace gsbench::fleet
