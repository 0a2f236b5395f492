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
