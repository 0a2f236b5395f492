#include <grid_test/example_grids.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <oracle/power_system.hpp>

namespace gsbench::oracle {
namespace {

using grid::overdamped_grid;

// All power comes promptly: M·f' = −loss − k·f, of which everyone knows the solution.
TEST(PowerSystem, IsAnExponentialWhereNothingIsReheated) {
  grid::Grid grid = overdamped_grid();
  grid.reheat_fraction = 1.0;
  const long double m = 2.0L * 2.0L * 1000.0L / 50.0L;             // MW per Hz/s
  const long double k = (1.0L + 0.95L / 0.05L) * 1000.0L / 50.0L;  // MW per Hz
  const PowerSystem system(grid);
  const std::vector<double> times_s = {0.0, 0.01, 0.1, 0.5, 1.0, 4.0};
  const std::vector<Sample> samples = system.simulate({{0.0, 100.0}}, times_s);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const long double decay = std::exp(-k / m * times_s[i]);
    // The parameters are doubles, 0.95 and 0.05 not exact ones.
    EXPECT_NEAR(static_cast<double>(samples[i].deviation_hz),
                static_cast<double>(-100.0L / k * (1.0L - decay)), 1e-15);
    EXPECT_NEAR(static_cast<double>(samples[i].rocof_hz_s),
                static_cast<double>(-100.0L / m * decay), 1e-14);
    EXPECT_NEAR(static_cast<double>(samples[i].phase_cycles),
                static_cast<double>(-100.0L / k * (times_s[i] - m / k * (1.0L - decay))), 1e-14);
  }
  EXPECT_FALSE(system.turn(100.0L).t_s);
  EXPECT_NEAR(static_cast<double>(system.turn(100.0L).deviation_hz), -0.25, 1e-15);
}

// H = 2 s, R = 0.05, D = 1, 10 % lost: figures known to three decimals.
TEST(PowerSystem, TurnsWhereAnOverdampedGridIsKnownTo) {
  const Turn turn = PowerSystem(overdamped_grid()).turn(100.0L);
  ASSERT_TRUE(turn.t_s);
  EXPECT_NEAR(static_cast<double>(*turn.t_s), 1.45, 0.5e-2);
  EXPECT_NEAR(static_cast<double>(turn.deviation_hz), 49.402 - 50.0, 0.5e-3);
  EXPECT_NEAR(static_cast<double>(turn.end_deviation_hz), 49.750 - 50.0, 0.5e-3);
}

// A machine cut in two is the same machine.
TEST(PowerSystem, DoesNotCareHowAPlantIsDivided) {
  const grid::Grid whole = overdamped_grid();
  grid::Grid halves = whole;
  halves.plants = {{"small", 300.0, 2.0, 0.05}, {"large", 700.0, 2.0, 0.05}};
  const Turn one = PowerSystem(whole).turn(100.0L);
  const Turn two = PowerSystem(halves).turn(100.0L);
  EXPECT_NEAR(static_cast<double>(*one.t_s - *two.t_s), 0.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(one.deviation_hz - two.deviation_hz), 0.0, 1e-17);
}

TEST(PowerSystem, PassesEachDeviationOnItsWayDown) {
  const PowerSystem system(overdamped_grid());
  const Turn turn = system.turn(100.0L);
  const auto rocofs = system.rocof_at_deviation(100.0L, {-1e-6L, -0.3L, turn.deviation_hz + 1e-9L});
  ASSERT_EQ(rocofs.size(), 3u);
  EXPECT_NEAR(static_cast<double>(rocofs[0]), -1.25, 1e-5);
  EXPECT_LT(rocofs[1], rocofs[2]);
  EXPECT_LT(rocofs[2], 0.0L);
  EXPECT_GT(rocofs[2], -1e-3L) << "a nanohertz above the turn it hardly falls";
}

}  // namespace
}  // namespace gsbench::oracle
