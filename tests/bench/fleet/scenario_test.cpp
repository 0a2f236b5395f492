#include <control_centre/threshold.hpp>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>
#include <profile/load.hpp>

namespace {

using gsbench::fleet::Control;
using gsbench::fleet::Fleet;
using gsbench::fleet::FleetOptions;
using gsbench::fleet::ScenarioOptions;
using gsbench::fleet::ScenarioResult;

const gsbench::grid::Grid& ieee24() {
  static const gsbench::grid::Grid grid = gsbench::profile::load_grid("ieee24");
  return grid;
}

// As many MW as the paper's, by fewer outlets that take more each.
Fleet small_fleet() {
  FleetOptions options;
  options.per_group = 20;
  options.least_w = 500.0;
  options.most_w = 90000.0;
  return make_fleet(options);
}

ScenarioResult play_control(Control control, double loss_mw = 500.0, double told_mw = 0.0,
                            std::size_t threads = 2) {
  static const Fleet fleet = small_fleet();
  ScenarioOptions options;
  options.control = control;
  options.loss_mw = loss_mw;
  options.threshold_mw = told_mw;
  gsbench::campaign::Execution execution;
  execution.threads = threads;
  return play(ieee24(), fleet, options, execution).value();
}

TEST(Scenario, WithoutControlTheFrequencyFallsAsTheModelSays) {
  const ScenarioResult result = play_control(Control::kNone);
  EXPECT_NEAR(result.nadir_hz, 49.290, 0.001);
  EXPECT_NEAR(result.nadir_s, 3.761, 0.003);
  EXPECT_EQ(result.shed.power_mw, 0.0);
  EXPECT_TRUE(std::isnan(result.first_action_s));
}

TEST(Scenario, OutletsShedWhatIsWantedWithinASecond) {
  const ScenarioResult result = play_control(Control::kGridSense);
  EXPECT_NEAR(result.shed.power_mw, result.wanted_mw, 0.01 * result.wanted_mw);
  EXPECT_GT(result.first_action_s, 0.85);
  EXPECT_LT(result.last_action_s, 0.96);
  EXPECT_GT(result.nadir_hz, 49.48);
  EXPECT_LT(result.nadir_hz, 49.50);
}

TEST(Scenario, BelowTheThresholdNobodySheds) {
  EXPECT_LT(play_control(Control::kGridSense, 320.0).shed.power_mw, 0.1);
}

TEST(Scenario, AThresholdThatKnowsOfTheDelayKeepsTheNadir) {
  const gsbench::grid::SfrModel model(ieee24());
  const double told_mw = gsbench::control_centre::threshold_for_delay_mw(model, 49.5, 500.0, 0.908);
  EXPECT_LT(told_mw, gsbench::control_centre::threshold_mw(model, 49.5));
  EXPECT_NEAR(play_control(Control::kGridSense, 500.0, told_mw).nadir_hz, 49.501, 0.001);
}

TEST(Scenario, SwitchingOffAloneComesLaterAndShedsFarTooMuch) {
  const ScenarioResult result = play_control(Control::kSwitchOff);
  EXPECT_GT(result.first_action_s, 1.2);
  EXPECT_NEAR(result.shed.power_mw, 892.0, 5.0);  // of 148 MW wanted and 906 there
}

TEST(Scenario, ACentralControllerShedsTheRightAmountTooLate) {
  const ScenarioResult result = play_control(Control::kCentral);
  EXPECT_NEAR(result.shed.power_mw, result.wanted_mw, 1e-6);
  EXPECT_DOUBLE_EQ(result.first_action_s, 1.9);
  EXPECT_LT(result.nadir_hz, play_control(Control::kGridSense).nadir_hz);
}

TEST(Scenario, RelaysActBelowTheirFrequencyAlone) {
  EXPECT_EQ(play_control(Control::kUfls).shed.power_mw, 0.0);
  const ScenarioResult result = play_control(Control::kUfls, 900.0);
  EXPECT_NEAR(result.shed.power_mw, 0.05 * ieee24().load_mw, 1e-6);  // one stage
  EXPECT_LT(result.nadir_hz, 49.0);
  EXPECT_GT(result.nadir_hz, 48.8);  // where the next would act
}

TEST(Scenario, IsTheSameOnAnyNumberOfThreads) {
  const ScenarioResult one = play_control(Control::kGridSense, 500.0, 0.0, 1);
  for (const std::size_t threads : {2U, 3U}) {
    const ScenarioResult other = play_control(Control::kGridSense, 500.0, 0.0, threads);
    EXPECT_EQ(other.shed.power_mw, one.shed.power_mw);
    EXPECT_EQ(other.nadir_hz, one.nadir_hz);
    EXPECT_EQ(other.shed.off_in_group, one.shed.off_in_group);
  }
}

TEST(Scenario, RefusesWhatMakesNoSense) {
  EXPECT_THROW(play_control(Control::kNone, 0.0), std::invalid_argument);
  EXPECT_THROW(play_control(Control::kNone, 1e5), std::invalid_argument);
}

}  // namespace
