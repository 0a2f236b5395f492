#include <grid_test/example_grids.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <oracle/power_system.hpp>

namespace gsbench::oracle {
namespace {

using grid::overdamped_grid;

// All power without delay: M·f' = −loss − k·f, which has an exponential solution.
TEST(PowerSystem, IsExponentialWithoutReheat) {
  grid::Grid grid = overdamped_grid();
  grid.reheat_fraction = 1.0;
  const long double m = 2.0L * 2.0L * 1000.0L / 50.0L;             // MW per Hz/s
  const long double k = (1.0L + 0.95L / 0.05L) * 1000.0L / 50.0L;  // MW per Hz
  const PowerSystem system(grid);
  const std::vector<double> times_s = {0.0, 0.01, 0.1, 0.5, 1.0, 4.0};
  const std::vector<Sample> samples = system.simulate({{0.0, 100.0}}, times_s);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const long double decay = std::exp(-k / m * times_s[i]);
    // The parameters 0.95 and 0.05 are not exact in doubles.
    EXPECT_NEAR(static_cast<double>(samples[i].deviation_hz),
                static_cast<double>(-100.0L / k * (1.0L - decay)), 1e-15);
    EXPECT_NEAR(static_cast<double>(samples[i].rocof_hz_s),
                static_cast<double>(-100.0L / m * decay), 1e-14);
    EXPECT_NEAR(static_cast<double>(samples[i].phase_cycles),
                static_cast<double>(-100.0L / k * (times_s[i] - m / k * (1.0L - decay))), 1e-14);
  }
  EXPECT_FALSE(system.nadir(100.0L).t_s);
  EXPECT_NEAR(static_cast<double>(system.nadir(100.0L).deviation_hz), -0.25, 1e-15);
}

// H = 2 s, R = 0.05, D = 1, 10 % lost: values known to three decimals.
TEST(PowerSystem, HasTheKnownNadirOfAnOverdampedGrid) {
  const Nadir nadir = PowerSystem(overdamped_grid()).nadir(100.0L);
  ASSERT_TRUE(nadir.t_s);
  EXPECT_NEAR(static_cast<double>(*nadir.t_s), 1.45, 0.5e-2);
  EXPECT_NEAR(static_cast<double>(nadir.deviation_hz), 49.402 - 50.0, 0.5e-3);
  EXPECT_NEAR(static_cast<double>(nadir.end_deviation_hz), 49.750 - 50.0, 0.5e-3);
}

// A plant split into two with the same parameters is equivalent.
TEST(PowerSystem, DoesNotDependOnTheSplitOfAPlant) {
  const grid::Grid whole = overdamped_grid();
  grid::Grid halves = whole;
  halves.plants = {{"small", 300.0, 2.0, 0.05}, {"large", 700.0, 2.0, 0.05}};
  const Nadir one = PowerSystem(whole).nadir(100.0L);
  const Nadir two = PowerSystem(halves).nadir(100.0L);
  EXPECT_NEAR(static_cast<double>(*one.t_s - *two.t_s), 0.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(one.deviation_hz - two.deviation_hz), 0.0, 1e-17);
}

TEST(PowerSystem, FindsTheRocofAtEachDeviation) {
  const PowerSystem system(overdamped_grid());
  const Nadir nadir = system.nadir(100.0L);
  const auto rocofs =
      system.rocof_at_deviation(100.0L, {-1e-6L, -0.3L, nadir.deviation_hz + 1e-9L});
  ASSERT_EQ(rocofs.size(), 3u);
  EXPECT_NEAR(static_cast<double>(rocofs[0]), -1.25, 1e-5);
  EXPECT_LT(rocofs[1], rocofs[2]);
  EXPECT_LT(rocofs[2], 0.0L);
  EXPECT_GT(rocofs[2], -1e-3L) << "the ROCOF is small 1 nHz above the nadir";
}

}  // namespace
}  // namespace gsbench::oracle
