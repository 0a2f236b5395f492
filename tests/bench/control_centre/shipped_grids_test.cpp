#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>
#include <grid_test/example_grids.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <grid/falling_limb.hpp>
#include <profile/load.hpp>

namespace gsbench::control_centre {
namespace {

using grid::kFourDecimals;
using grid::kThreeDecimals;
using grid::kTwoDecimals;

TEST(ShippedGrids, HaveTheCalibratedIeee24BusSystem) {
  const grid::Grid grid = profile::load_grid("ieee24");
  const grid::SfrModel model(grid), expected(grid::ieee24());
  EXPECT_DOUBLE_EQ(model.inertia_s(), expected.inertia_s());
  EXPECT_DOUBLE_EQ(model.droop_pu(), expected.droop_pu());
  EXPECT_NEAR(threshold_mw(model, grid.threshold_hz), 351.92, kTwoDecimals);
}

TEST(ShippedGrids, HaveTheIeee24BusSystemByUnit) {
  const grid::Grid grid = profile::load_grid("ieee24-by-unit");
  const grid::SfrModel model(grid);
  EXPECT_NEAR(model.inertia_s(), 7.826, kThreeDecimals);
  EXPECT_NEAR(1.0 / model.droop_pu(), 19.770, kThreeDecimals);
  EXPECT_NEAR(threshold_mw(model, grid.threshold_hz), 320.67, kTwoDecimals);
  EXPECT_NEAR(grid::nadir(model, 100.0).t_s, 3.564, kThreeDecimals);
}

double largest_difference_from_print_hz_s(const grid::Grid& grid) {
  const auto rows = conditions(grid::SfrModel(grid), grid.threshold_hz, grid.condition_row_hz);
  const std::vector<double>& printed = grid.reference.condition_rocof_hz_s;
  EXPECT_EQ(rows.size(), printed.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(rows.size(), printed.size()); ++i) {
    largest = std::max(largest, std::abs(rows[i].rocof_below_hz_s - printed[i]));
  }
  return largest;
}

// The difference from Table 1 is the reason for shipping two grids.
TEST(ShippedGrids, ReproduceTable1OnlyWithTheCalibratedSystem) {
  EXPECT_LT(largest_difference_from_print_hz_s(profile::load_grid("ieee24")), 3e-4);
  EXPECT_NEAR(largest_difference_from_print_hz_s(profile::load_grid("ieee24-by-unit")), 0.0232,
              kFourDecimals);
}

TEST(ShippedGrids, HaveBlocksToShedAfterTheLossOf500Mw) {
  const auto blocks = block_settings(profile::load_grid("ieee24"));
  ASSERT_EQ(blocks.size(), 10u);
  EXPECT_GT(blocks.back().accumulated_mw, 500.0 - 351.92);
}

// Outlets can still keep f_s after it, and need not shed much more than eq. (15) wants.
TEST(ShippedGrids, HaveACredibleLossThatOutletsAnswerInTime) {
  for (const char* const name : {"ieee24", "ieee24-by-unit", "island-60hz"}) {
    const grid::Grid grid = profile::load_grid(name);
    const grid::SfrModel model(grid);
    ASSERT_TRUE(grid.credible_loss_mw.has_value()) << name;
    const double threshold =
        threshold_for_delay_mw(model, grid.threshold_hz, *grid.credible_loss_mw, kOutletDelay_s);
    EXPECT_EQ(threshold_mw(grid, Rules::kGsbench), threshold) << name;
    const double by_eq15 = threshold_mw(grid, Rules::kPaper);
    EXPECT_GT(threshold, 0.88 * by_eq15) << name;
    EXPECT_LT(threshold, 0.98 * by_eq15) << name;
  }
}

TEST(ShippedGrids, HaveA60HzSystemWithTextbookConstants) {
  const grid::Grid grid = profile::load_grid("island-60hz");
  const grid::SfrModel model(grid);
  EXPECT_EQ(grid.nominal_hz, 60.0);
  EXPECT_NEAR(model.inertia_s(), 4.0, 0.05) << "near the 4 s of Anderson and Mirheydar";
  EXPECT_DOUBLE_EQ(model.droop_pu(), 0.05);
  // A useful threshold: more than a small unit, less than a large one.
  const double threshold = threshold_mw(model, grid.threshold_hz);
  EXPECT_GT(threshold, 200.0);
  EXPECT_LT(threshold, 1000.0);
  EXPECT_FALSE(block_settings(grid).empty());
}

}  // namespace
}  // namespace gsbench::control_centre
