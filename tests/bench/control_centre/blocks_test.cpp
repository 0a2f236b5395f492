#include <control_centre/blocks.hpp>
#include <grid_test/example_grids.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::control_centre {
namespace {

using grid::expect_refused;

grid::Grid grid_of(std::vector<grid::Block> blocks) {
  grid::Grid grid = grid::ieee24();
  grid.load_mw = 2000.0;
  grid.blocks = std::move(blocks);
  return grid;
}

TEST(Accumulation, IncludesHalfOfTheOwnGroupOrAllOfItByEquation11) {
  EXPECT_EQ(accumulated_mw(100.0, 30.0), 115.0);
  EXPECT_EQ(accumulated_mw(100.0, 30.0, Accumulation::kWholeGroup), 130.0);
}

// Required powers spread evenly over equal blocks; each block is shed if the required power exceeds
// its P^A. With the whole group in P^A, half a block too little is shed.
TEST(Accumulation, OfHalfTheGroupShedsTheRequiredPowerOnAverage) {
  const grid::Grid grid = grid_of(std::vector<grid::Block>(10, {"of ten", 20.0}));
  for (const bool whole : {false, true}) {
    double error_mw = 0.0;
    constexpr int kCases = 1000;
    const auto blocks =
        block_settings(grid, whole ? Accumulation::kWholeGroup : Accumulation::kHalfGroup);
    for (int i = 0; i < kCases; ++i) {
      const double required_mw = 20.0 + 160.0 * (i + 0.5) / kCases;
      error_mw -= required_mw;
      for (const BlockSetting& block : blocks) {
        error_mw += required_mw > block.accumulated_mw ? block.power_mw : 0.0;
      }
    }
    EXPECT_NEAR(error_mw / kCases, whole ? -10.0 : 0.0, 0.2);
  }
}

TEST(BlockSettings, AccumulatePowerAndReferEquation17ToTheRemainingLoad) {
  const auto settings = block_settings(grid_of({{"a", 50.0}, {"b", 100.0}, {"c", 25.0}}));
  ASSERT_EQ(settings.size(), 3u);
  EXPECT_EQ(settings[0].id, "a");
  EXPECT_EQ(settings[2].id, "c");
  EXPECT_EQ(settings[1].power_mw, 100.0);
  EXPECT_EQ(settings[0].accumulated_mw, 25.0);
  EXPECT_EQ(settings[1].accumulated_mw, 100.0);
  EXPECT_EQ(settings[2].accumulated_mw, 162.5);
  // Eq. (17) by hand: 50/(2.5·2000)·50, 100/(2.5·1950)·50 and 25/(2.5·1850)·50 below 49.5 Hz.
  EXPECT_NEAR(settings[0].switch_off_hz, 49.0, 1e-12);
  EXPECT_NEAR(settings[1].switch_off_hz, 48.474358974359, 1e-12);
  EXPECT_NEAR(settings[2].switch_off_hz, 49.229729729730, 1e-12);
}

TEST(BlockSettings, AreEmptyForAGridWithoutBlocks) {
  EXPECT_TRUE(block_settings(grid::ieee24()).empty());
}

TEST(BlockSettings, RefuseAnInvalidGrid) {
  grid::Grid grid = grid_of({{"a", -50.0}});
  const auto settings = [&] { (void)block_settings(grid); };
  expect_refused(settings, "block.power_mw", 0, "power_mw is -50");
  grid = grid_of({{"a", 5.0}, {"b", 50.0}});
  grid.damping_pu = 0.02;
  expect_refused(settings, "block.power_mw", 1,
                 "which gives a switching-off frequency, eq. (17), of -");
  grid.damping_pu = 0.0;
  expect_refused(settings, "system.damping_pu", -1,
                 "damping_pu is 0; it must be above 0 if there are blocks");
}

TEST(SwitchOffFrequency, EqualsThatOfABlockWithTheSamePowers) {
  const grid::Grid grid = grid_of({{"a", 50.0}, {"b", 100.0}});
  EXPECT_EQ(switch_off_hz(grid, 50.0, 100.0), block_settings(grid)[1].switch_off_hz);
}

TEST(SwitchOffFrequency, RefusesInvalidPowers) {
  const grid::Grid grid = grid::ieee24();
  const double nan = std::nan("");
  EXPECT_THROW(switch_off_hz(grid, 100.0, -1.0), std::invalid_argument);
  EXPECT_THROW(switch_off_hz(grid, -1.0, 100.0), std::invalid_argument);
  EXPECT_THROW(switch_off_hz(grid, 2646.0, 100.0), std::invalid_argument);
  EXPECT_THROW(switch_off_hz(grid, nan, 100.0), std::invalid_argument);
  EXPECT_THROW(switch_off_hz(grid, 100.0, nan), std::invalid_argument);
}

TEST(SwitchOffFrequency, IsTheThresholdWithoutLoadEvenWithoutDamping) {
  grid::Grid grid = grid::ieee24();
  grid.damping_pu = 0.0;
  EXPECT_EQ(switch_off_hz(grid, 0.0, 0.0), grid.threshold_hz);
  EXPECT_THROW(switch_off_hz(grid, 50.0, 50.0), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::control_centre
