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
  const auto settings = block_settings(grid_of({{"a", 50.0}, {"b", 100.0}, {"c", 25.0}}),
                                       Accumulation::kHalfGroup, Rules::kPaper);
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

// ieee24: a tenth of 0.5 Hz below 49.5 Hz, and 0.5 Hz for each 4 · 351.92 MW.
TEST(Stages, BeginATenthBelowTheThresholdFrequencyAndFallWithTheAccumulatedPower) {
  const Stages stages(grid::ieee24());
  EXPECT_NEAR(stages.first_hz(), 49.45, 1e-12);
  EXPECT_NEAR(stages.mw_per_hz(), 2815.4, 0.1);
  EXPECT_NEAR(stages.switch_off_hz(0.0), 49.45, 1e-12);
  EXPECT_NEAR(stages.switch_off_hz(100.0), 49.41448, 1e-5);
  EXPECT_NEAR(stages.switch_off_hz(351.92), 49.325, 1e-5);
}

TEST(Stages, AreTheSameForFewLargeBlocksAndForManySmallOnes) {
  const Stages stages(grid::ieee24());
  for (const std::size_t count : {10U, 1000U}) {
    const grid::Grid grid = grid_of(
        std::vector<grid::Block>(count, {"one of equal", 900.0 / static_cast<double>(count)}));
    const auto blocks = block_settings(grid);
    for (const BlockSetting& block : blocks) {
      EXPECT_EQ(block.switch_off_hz, stages.switch_off_hz(block.accumulated_mw));
    }
    const double last_mw = blocks.back().power_mw;
    EXPECT_NEAR(blocks.front().switch_off_hz - blocks.back().switch_off_hz,
                (900.0 - last_mw) / stages.mw_per_hz(), 1e-9);
  }
}

// Which is why they all switch off together.
TEST(Equation17, HasAllOfAThousandBlocksWithin10Millihertz) {
  const auto blocks = block_settings(grid_of(std::vector<grid::Block>(1000, {"one of equal", 0.9})),
                                     Accumulation::kHalfGroup, Rules::kPaper);
  EXPECT_GT(blocks.back().switch_off_hz, blocks.front().switch_off_hz - 0.01);
}

TEST(Stages, UseTheAccumulatedPowerAsSent) {
  const grid::Grid grid = grid_of({{"a", 50.0}, {"b", 100.0}});
  const Stages stages(grid);
  EXPECT_EQ(block_settings(grid)[1].switch_off_hz, stages.switch_off_hz(100.0));
  EXPECT_EQ(block_settings(grid, Accumulation::kWholeGroup)[1].switch_off_hz,
            stages.switch_off_hz(150.0));
}

TEST(Stages, DoNotNeedDamping) {
  grid::Grid grid = grid_of({{"a", 50.0}});
  grid.damping_pu = 0.0;
  EXPECT_EQ(block_settings(grid)[0].switch_off_hz, Stages(grid).switch_off_hz(25.0));
}

TEST(Stages, RefuseABlockThatWouldSwitchOffBelow0Hz) {
  grid::Grid grid = grid_of({{"a", 5.0}});
  grid.threshold_hz = 1.0;  // a tenth of 49 Hz below 1 Hz
  expect_refused([&] { (void)block_settings(grid); }, "block.power_mw", 0,
                 "which gives a switching-off frequency of -");
}

TEST(BlockSettings, AreEmptyForAGridWithoutBlocks) {
  EXPECT_TRUE(block_settings(grid::ieee24()).empty());
}

TEST(BlockSettings, RefuseAnInvalidGrid) {
  grid::Grid grid = grid_of({{"a", -50.0}});
  const auto settings = [&] {
    (void)block_settings(grid, Accumulation::kHalfGroup, Rules::kPaper);
  };
  expect_refused(settings, "block.power_mw", 0, "power_mw is -50");
  grid = grid_of({{"a", 5.0}, {"b", 50.0}});
  grid.damping_pu = 0.02;
  expect_refused(settings, "block.power_mw", 1,
                 "which gives a switching-off frequency, eq. (17), of -");
  grid.damping_pu = 0.0;
  expect_refused(settings, "system.damping_pu", -1,
                 "damping_pu is 0; it must be above 0 if there are blocks");
}

TEST(Equation17, EqualsThatOfABlockWithTheSamePowers) {
  const grid::Grid grid = grid_of({{"a", 50.0}, {"b", 100.0}});
  EXPECT_EQ(eq17_switch_off_hz(grid, 50.0, 100.0),
            block_settings(grid, Accumulation::kHalfGroup, Rules::kPaper)[1].switch_off_hz);
}

TEST(Equation17, RefusesInvalidPowers) {
  const grid::Grid grid = grid::ieee24();
  const double nan = std::nan("");
  EXPECT_THROW(eq17_switch_off_hz(grid, 100.0, -1.0), std::invalid_argument);
  EXPECT_THROW(eq17_switch_off_hz(grid, -1.0, 100.0), std::invalid_argument);
  EXPECT_THROW(eq17_switch_off_hz(grid, 2646.0, 100.0), std::invalid_argument);
  EXPECT_THROW(eq17_switch_off_hz(grid, nan, 100.0), std::invalid_argument);
  EXPECT_THROW(eq17_switch_off_hz(grid, 100.0, nan), std::invalid_argument);
}

TEST(Equation17, IsTheThresholdWithoutLoadEvenWithoutDamping) {
  grid::Grid grid = grid::ieee24();
  grid.damping_pu = 0.0;
  EXPECT_EQ(eq17_switch_off_hz(grid, 0.0, 0.0), grid.threshold_hz);
  EXPECT_THROW(eq17_switch_off_hz(grid, 50.0, 50.0), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::control_centre
