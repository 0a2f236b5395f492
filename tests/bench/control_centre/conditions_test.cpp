#include <control_centre/threshold.hpp>
#include <grid_test/example_grids.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <grid/falling_limb.hpp>

namespace gsbench::control_centre {
namespace {

TEST(Conditions, EqualTable1OfThePaper) {
  const double printed_hz_s[] = {-0.3236, -0.2987, -0.2729, -0.2461, -0.2179,
                                 -0.1879, -0.1557, -0.1200, -0.0779, 0.0};
  const std::vector<Condition> rows = conditions(grid::SfrModel(grid::ieee24()), 49.5, 0.05);
  ASSERT_EQ(rows.size(), std::size(printed_hz_s));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double row = static_cast<double>(i);
    // 3e-4: the difference that remains after calibrating H and R.
    EXPECT_NEAR(rows[i].rocof_below_hz_s, printed_hz_s[i], 3e-4) << "row " << i;
    EXPECT_NEAR(rows[i].from_hz, 49.95 - 0.05 * row, 1e-12);
    EXPECT_NEAR(rows[i].to_hz, 50.0 - 0.05 * row, 1e-12);
  }
}

TEST(Conditions, EndWithExactlyZeroAtTheThreshold) {
  for (const grid::Grid& grid :
       {grid::ieee24(), grid::overdamped_grid(), grid::first_order_grid()}) {
    const Condition last = conditions(grid::SfrModel(grid), 49.5, 0.05).back();
    EXPECT_EQ(last.from_hz, 49.5);
    EXPECT_EQ(last.rocof_below_hz_s, 0.0);
    EXPECT_FALSE(std::signbit(last.rocof_below_hz_s)) << "must be printed as 0, not −0";
  }
}

TEST(Conditions, CoverTheRangeFromNominalToThresholdWithoutAGap) {
  struct Rows {
    double threshold_hz;
    double row_hz;
    std::size_t count;
    double last_height_hz;
  };
  // In floating point, 50 − 49.8 is not exactly four rows of 0.05; it must still give four.
  const Rows all[] = {{49.5, 0.05, 10, 0.05},   {49.8, 0.05, 4, 0.05}, {49.5, 0.1, 5, 0.1},
                      {49.5, 0.07, 8, 0.01},    {49.5, 0.3, 2, 0.2},   {49.5, 2.0, 1, 0.5},
                      {49.5, 0.001, 500, 0.001}};
  for (const auto& [threshold_hz, row_hz, count, last_height_hz] : all) {
    for (const grid::Grid& grid :
         {grid::ieee24(), grid::overdamped_grid(), grid::first_order_grid()}) {
      const std::vector<Condition> rows = conditions(grid::SfrModel(grid), threshold_hz, row_hz);
      ASSERT_EQ(rows.size(), count);
      EXPECT_EQ(rows.front().to_hz, 50.0);
      EXPECT_EQ(rows.back().from_hz, threshold_hz);
      EXPECT_NEAR(rows.back().to_hz - rows.back().from_hz, last_height_hz, 1e-12);
      for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].to_hz, rows[i - 1].from_hz);
        EXPECT_GT(rows[i].rocof_below_hz_s, rows[i - 1].rocof_below_hz_s);
      }
    }
  }
}

TEST(Conditions, HaveTheRocofAtWhichTheThresholdLossPassesTheLowerEdge) {
  for (const grid::Grid& grid : {grid::ieee24(), grid::overdamped_grid(), grid::grid_of_zeta(1.0),
                                 grid::first_order_grid()}) {
    const grid::SfrModel model(grid);
    const double loss_mw = threshold_mw(model, 49.5);
    const std::vector<Condition> rows = conditions(model, 49.5, 0.05);
    const double end_s = grid::nadir(model, loss_mw).t_s;
    std::size_t row = 0;
    // Follows the falling limb in steps in which f changes by less than 1e-4 Hz.
    double before_hz_s = model.unit_rocof_hz_s(0.0) * loss_mw;
    for (double t_s = 0.0; t_s < end_s && row + 1 < rows.size(); t_s += 1e-4) {
      const double f_hz = 50.0 + loss_mw * model.unit_deviation_hz(t_s);
      const double rocof_hz_s = loss_mw * model.unit_rocof_hz_s(t_s);
      if (f_hz < rows[row].from_hz) {
        EXPECT_GE(rows[row].rocof_below_hz_s, before_hz_s) << "row " << row;
        EXPECT_LE(rows[row].rocof_below_hz_s, rocof_hz_s) << "row " << row;
        ++row;
      }
      before_hz_s = rocof_hz_s;
    }
    EXPECT_EQ(row + 1, rows.size());
  }
}

TEST(Conditions, RefuseAThresholdThatIsNotBelowNominal) {
  EXPECT_THROW(conditions(grid::SfrModel(grid::ieee24()), 50.0, 0.05), std::invalid_argument);
}

TEST(Conditions, RefuseRowsBelowOneMillihertz) {
  const grid::SfrModel model(grid::ieee24());
  for (const double row_hz : {0.0009, 0.0, -0.05, std::nan("")}) {
    EXPECT_THROW(conditions(model, 49.5, row_hz), std::invalid_argument) << row_hz;
  }
}

}  // namespace
}  // namespace gsbench::control_centre
