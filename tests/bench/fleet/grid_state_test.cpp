// The exact state of the grid's frequency, compared with the sum of responses and with small steps.
#include <test_support/ieee24.hpp>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fleet/grid_state.hpp>

namespace gsbench::fleet {
namespace {

using test::ieee24;

// zeta = 0.75 as shipped; 1.14 with low inertia (one plant of 2 s on its rating).
grid::Grid overdamped() {
  grid::Grid grid = ieee24();
  grid.plants = {{"one", grid.base_mw, 2.0, 0.05}};
  grid.damping_pu = 1.0;
  return grid;
}

class OnGrid : public testing::TestWithParam<bool> {
 protected:
  const grid::SfrModel model{GetParam() ? overdamped() : ieee24()};
};

INSTANTIATE_TEST_SUITE_P(Any, OnGrid, testing::Bool(), [](const auto& each) {
  return each.param ? "Overdamped" : "Underdamped";
});

const std::vector<grid::PowerChange> kChanges = {{-1.0, 120.0}, {2.0, 500.0},  {2.3, -80.0},
                                                 {2.3, -40.0},  {3.1, -120.0}, {9.0, 33.0}};

TEST_P(OnGrid, ChangesCostNoExactness) {
  GridResponse response(model);
  for (const grid::PowerChange& change : kChanges) {
    response.change(change.at_s, change.power_mw);
  }
  const grid::FrequencyResponse sum(model, kChanges);
  for (double t_s = -2.0; t_s < 40.0; t_s += 0.037) {
    const GridState state = response.at(t_s);
    EXPECT_NEAR(model.nominal_hz() + state.deviation_hz, sum.frequency_hz(t_s), 1e-12);
    EXPECT_NEAR(state.slope_hz_s, sum.rocof_hz_s(t_s), 1e-12);
    EXPECT_NEAR(state.cycles, sum.excess_cycles(t_s), 1e-11);
  }
  EXPECT_DOUBLE_EQ(response.at(8.0).power_mw, 380.0);
}

TEST_P(OnGrid, TheSlopeIsTheRightHandLimitAtAChange) {
  GridResponse response(model);
  response.change(2.0, 500.0);
  EXPECT_EQ(response.at(std::nextafter(2.0, 0.0)).slope_hz_s, 0.0);
  EXPECT_NEAR(response.at(2.0).slope_hz_s,
              -500.0 * model.gain_hz_per_mw() * model.initial_slope_per_s(), 1e-12);
  EXPECT_EQ(response.at(2.0).deviation_hz, 0.0);
}

// From states that rise and fall, above and below their final value.
TEST_P(OnGrid, TheLowestDeviationIsThatOfSmallSteps) {
  int minima = 0;
  for (const double deviation_hz : {-0.6, -0.1, 0.0, 0.3}) {
    for (const double slope_hz_s : {-0.5, -0.01, 0.0, 0.02, 0.6}) {
      for (const double power_mw : {-300.0, 0.0, 150.0, 600.0}) {
        const GridState state = {deviation_hz, slope_hz_s, power_mw, 0.0};
        double lowest_hz = deviation_hz;
        for (double t_s = 0.0; t_s < 120.0; t_s += 0.005) {
          lowest_hz = std::min(lowest_hz, later(model, state, t_s).deviation_hz);
        }
        EXPECT_NEAR(lowest_deviation_hz(model, state), lowest_hz, 5e-6)
            << deviation_hz << ' ' << slope_hz_s << ' ' << power_mw;
        const double final_hz = -model.gain_hz_per_mw() * power_mw;
        minima += lowest_hz < std::min(deviation_hz, final_hz) - 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(minima, 15);  // of 80 states; the others are lowest at once or at the end
  EXPECT_LT(minima, 70);
}

TEST_P(OnGrid, ALossFromNominalHasTheNadirOfTheModel) {
  const GridState after = with_power(model, {}, 500.0);
  double lowest_hz = 0.0;
  for (double t_s = 0.0; t_s < 60.0; t_s += 0.001) {
    lowest_hz = std::min(lowest_hz, 500.0 * model.unit_deviation_hz(t_s));
  }
  EXPECT_NEAR(lowest_deviation_hz(model, after), lowest_hz, 1e-6);
}

TEST(GridResponse, RejectsChangesThatAreNotInTheOrderOfTime) {
  GridResponse response{grid::SfrModel(ieee24())};
  response.change(2.0, 1.0);
  response.change(2.0, 1.0);
  EXPECT_THROW(response.change(1.9, 1.0), std::invalid_argument);
  EXPECT_THROW(response.change(3.0, std::nan("")), std::invalid_argument);
  EXPECT_EQ(response.changes_s(2.0, 3.0).size(), 1U);  // both at once
  EXPECT_TRUE(response.changes_s(0.0, 2.0).empty());
}

}  // namespace
}  // namespace gsbench::fleet
