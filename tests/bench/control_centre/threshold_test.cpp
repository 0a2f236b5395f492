#include <control_centre/threshold.hpp>
#include <grid_test/example_grids.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <grid/falling_limb.hpp>

namespace gsbench::control_centre {
namespace {

using grid::kTwoDecimals;

TEST(Threshold, HasTheKnownValueForTheCalibratedIeee24BusSystem) {
  const double threshold = threshold_mw(grid::SfrModel(grid::ieee24()), 49.5);
  EXPECT_NEAR(threshold, 351.92, kTwoDecimals);
  EXPECT_NEAR(threshold, 351.90, 0.1) << "value of the paper, within the calibration's accuracy";
}

TEST(Threshold, IsTheLossWithANadirAtTheThresholdFrequency) {
  for (const grid::Grid& grid : {grid::ieee24(), grid::overdamped_grid(), grid::grid_of_zeta(1.0),
                                 grid::first_order_grid()}) {
    const grid::SfrModel model(grid);
    for (const double threshold_hz : {49.0, 49.5, 49.9}) {
      EXPECT_NEAR(grid::nadir(model, threshold_mw(model, threshold_hz)).frequency_hz, threshold_hz,
                  1e-13);
    }
  }
}

TEST(Threshold, RefusesAFrequencyThatIsNotBelowNominal) {
  const grid::SfrModel model(grid::ieee24());
  for (const double threshold_hz : {50.0, 51.0, 0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(threshold_mw(model, threshold_hz), std::invalid_argument) << threshold_hz;
  }
}

TEST(KLse, HasTheKnownValueForTheIeee24BusSystem) {
  EXPECT_NEAR(k_lse_mw_per_hz_s(grid::SfrModel(grid::ieee24())), -1011.92, kTwoDecimals);
}

TEST(KLse, ConvertsTheInitialRocofToTheLoss) {
  for (const grid::Grid& grid :
       {grid::ieee24(), grid::overdamped_grid(), grid::grid_of_zeta(1.0)}) {
    const grid::SfrModel model(grid);
    const grid::FrequencyResponse response(model, {{0.0, 321.0}});
    EXPECT_NEAR(k_lse_mw_per_hz_s(model) * response.rocof_hz_s(0.0), 321.0, 1e-10);
  }
}

double lowest_hz(const grid::SfrModel& model, double loss_mw, double shed_mw, double delay_s) {
  const grid::FrequencyResponse response(model, {{0.0, loss_mw}, {delay_s, -shed_mw}});
  double lowest = response.frequency_hz(0.0);
  for (double t_s = 0.0; t_s < 30.0; t_s += 0.001) {
    lowest = std::min(lowest, response.frequency_hz(t_s));
  }
  return lowest;
}

TEST(ThresholdForDelay, EqualsThePapersThresholdWithoutDelayOrShedding) {
  const grid::SfrModel model(grid::ieee24());
  EXPECT_DOUBLE_EQ(threshold_for_delay_mw(model, 49.5, 500.0, 0.0), threshold_mw(model, 49.5));
  EXPECT_DOUBLE_EQ(threshold_for_delay_mw(model, 49.5, 300.0, 1.0), threshold_mw(model, 49.5));
}

// The paper's threshold does not: 49.486 Hz for a delay of 0.96 s.
TEST(ThresholdForDelay, KeepsTheNadirAtTheThresholdFrequencyForAnyDelay) {
  const grid::SfrModel model(grid::ieee24());
  EXPECT_LT(lowest_hz(model, 500.0, 500.0 - threshold_mw(model, 49.5), 0.96), 49.487);
  for (const double delay_s : {0.2, 0.64, 0.96}) {
    for (const double loss_mw : {400.0, 500.0, 600.0}) {
      const double corrected_mw = threshold_for_delay_mw(model, 49.5, loss_mw, delay_s);
      EXPECT_NEAR(lowest_hz(model, loss_mw, loss_mw - corrected_mw, delay_s), 49.5, 2e-4)
          << loss_mw << " MW, " << delay_s << " s";
    }
  }
}

// 500 MW on ieee24: 351.92 MW by eq. (15) are 11.8 MW too much.
TEST(DelayAwareThreshold, KeepsTheNadirAtTheThresholdFrequencyAfterTheCredibleLoss) {
  grid::Grid grid = grid::ieee24();
  grid.credible_loss_mw = 500.0;
  const double threshold = delay_aware_threshold_mw(grid);
  EXPECT_NEAR(threshold, 340.12, kTwoDecimals);
  EXPECT_EQ(threshold_mw(grid, Rules::kGsbench), threshold);
  EXPECT_NEAR(lowest_hz(grid::SfrModel(grid), 500.0, 500.0 - threshold, kOutletDelay_s), 49.5,
              2e-4);
  EXPECT_EQ(threshold_mw(grid, Rules::kPaper), threshold_mw(grid::SfrModel(grid), 49.5));
}

TEST(DelayAwareThreshold, IsFor1p4TimesEquation15IfTheGridStatesNoCredibleLoss) {
  grid::Grid grid = grid::ieee24();
  const double by_default = delay_aware_threshold_mw(grid);
  EXPECT_NEAR(credible_loss_mw(grid), 1.4 * 351.92, 0.02);
  grid.credible_loss_mw = credible_loss_mw(grid);
  EXPECT_EQ(delay_aware_threshold_mw(grid), by_default);
  grid.credible_loss_mw = 300.0;
  EXPECT_EQ(delay_aware_threshold_mw(grid), threshold_mw(grid::SfrModel(grid), 49.5));
}

// The frequency is below f_s before outlets act: after 660 MW even with all of it shed.
TEST(DelayAwareThreshold, KeepsTheNadirWithin10MillihertzOfTheBestIfTheLimitIsOutOfReach) {
  grid::Grid grid = grid::ieee24();
  const grid::SfrModel model(grid);
  double before_mw = delay_aware_threshold_mw(grid);
  for (const double loss_mw : {600.0, 650.0, 665.0, 680.0}) {
    grid.credible_loss_mw = loss_mw;
    const double threshold = delay_aware_threshold_mw(grid);
    const double best = lowest_hz(model, loss_mw, loss_mw, kOutletDelay_s);
    EXPECT_NEAR(lowest_hz(model, loss_mw, loss_mw - threshold, kOutletDelay_s),
                std::min(49.5, best - 0.010), 2e-4)
        << loss_mw;
    EXPECT_LT(std::abs(threshold - before_mw), 30.0) << "continuous at " << loss_mw;
    before_mw = threshold;
  }
  for (const double loss_mw : {900.0, 2745.0}) {
    grid.credible_loss_mw = loss_mw;
    EXPECT_EQ(delay_aware_threshold_mw(grid), threshold_mw(model, 49.5)) << loss_mw;
  }
}

// The frequency falls to f_s before outlets act, or turns by itself.
TEST(DelayAwareThreshold, IsAboveZeroAndAtMostThatOfEquation15ForAnyGrid) {
  for (const grid::Grid& grid : {grid::overdamped_grid(), grid::grid_of_zeta(1.0),
                                 grid::grid_of_zeta(0.7), grid::first_order_grid()}) {
    const double by_eq15 = threshold_mw(grid, Rules::kPaper);
    EXPECT_GT(delay_aware_threshold_mw(grid), 0.5 * by_eq15);
    EXPECT_LE(delay_aware_threshold_mw(grid), by_eq15);
  }
}

TEST(ThresholdForDelay, IsZeroIfNoSheddingSuffices) {
  EXPECT_EQ(threshold_for_delay_mw(grid::SfrModel(grid::ieee24()), 49.5, 2000.0, 5.0), 0.0);
}

TEST(ThresholdForDelay, RefusesInvalidArguments) {
  const grid::SfrModel model(grid::ieee24());
  EXPECT_THROW(threshold_for_delay_mw(model, 49.5, -1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(threshold_for_delay_mw(model, 49.5, 500.0, -1.0), std::invalid_argument);
  EXPECT_THROW(threshold_for_delay_mw(model, 50.5, 500.0, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::control_centre
