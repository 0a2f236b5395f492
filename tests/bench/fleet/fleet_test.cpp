// A fleet, and the load that it sheds under each control.
#include <control_centre/threshold.hpp>
#include <test_support/ieee24.hpp>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::fleet {
namespace {

using control_centre::Accumulation;
using test::ieee24;

constexpr float kThreshold_mw = 351.92F;

// The power of the paper's fleet in fewer, larger outlets.
Fleet small_fleet(Accumulation accumulation = Accumulation::kHalfGroup) {
  FleetOptions options;
  options.per_group = 20;
  options.least_w = 500.0;
  options.most_w = 90000.0;
  options.accumulation = accumulation;
  return make_fleet(options);
}

TEST(Fleet, HasTheAccumulatedPowerOfItsGroupsInOrder) {
  const Fleet fleet = small_fleet(Accumulation::kWholeGroup);
  ASSERT_EQ(fleet.outlets(), 20000U);
  ASSERT_EQ(fleet.groups(), 1000U);
  EXPECT_NEAR(std::accumulate(fleet.group_mw.begin(), fleet.group_mw.end(), 0.0), fleet.power_mw,
              1e-9);
  EXPECT_NEAR(fleet.power_mw, 905.0, 10.0);
  EXPECT_DOUBLE_EQ(fleet.accumulated_mw[0], fleet.group_mw[0]);  // eq. (11)
  EXPECT_NEAR(fleet.accumulated_mw.back(), fleet.power_mw, 1e-9);
  for (const float power_w : fleet.power_w) {
    ASSERT_GE(power_w, 500.0F);
    ASSERT_LE(power_w, 90000.0F);
  }
}

TEST(Fleet, ShedsTheRequiredPowerByItsEstimates) {
  const Fleet fleet = small_fleet();
  const std::vector<float> exact(fleet.outlets(), 500.0F);
  const Shed shed = shed_by_estimates(fleet, exact, kThreshold_mw);
  EXPECT_NEAR(shed.power_mw, 148.08, 0.5);  // within half a group
  EXPECT_EQ(shed.first_partly, shed.end_partly);
  EXPECT_EQ(shed.outlets, 20 * shed.first_partly);
  const std::vector<float> none(fleet.outlets(), 351.0F);
  EXPECT_EQ(shed_by_estimates(fleet, none, kThreshold_mw).outlets, 0U);
}

TEST(Fleet, RejectsOptionsOutOfRange) {
  FleetOptions options;
  options.groups = 0;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
  options = {};
  options.per_group = 1000000;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
  options = {};
  options.least_w = 2000.0;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
}

ScenarioResult simulate_with(const ScenarioOptions& options, std::size_t threads = 2) {
  static const Fleet fleet = small_fleet();
  campaign::Execution execution;
  execution.threads = threads;
  return simulate(ieee24(), fleet, options, execution).value();
}

ScenarioResult simulate_control(Control control, double loss_mw = 500.0, double threshold_mw = 0.0,
                                std::size_t threads = 2) {
  ScenarioOptions options;
  options.control = control;
  options.loss_mw = loss_mw;
  options.threshold_mw = threshold_mw;
  return simulate_with(options, threads);
}

ScenarioResult simulate_by_papers_rules(Control control) {
  ScenarioOptions options;
  options.control = control;
  options.rules = control_centre::Rules::kPaper;
  return simulate_with(options);
}

TEST(Scenario, WithoutControlTheFrequencyFollowsTheModel) {
  const ScenarioResult result = simulate_control(Control::kNone);
  EXPECT_NEAR(result.nadir_hz, 49.290, 0.001);
  EXPECT_NEAR(result.nadir_s, 3.761, 0.003);
  EXPECT_EQ(result.shed.power_mw, 0.0);
  EXPECT_TRUE(std::isnan(result.first_action_s));
}

TEST(Scenario, OutletsShedTheRequiredPowerWithinASecondAndKeepTheLimit) {
  const ScenarioResult result = simulate_control(Control::kGridSense);
  EXPECT_NEAR(result.threshold_mw, 340.12, 0.01);
  EXPECT_NEAR(result.required_mw, 159.88, 0.01);
  EXPECT_NEAR(result.shed.power_mw, result.required_mw, 0.01 * result.required_mw);
  EXPECT_GT(result.first_action_s, 0.85);
  EXPECT_LT(result.last_action_s, 0.96);
  EXPECT_GE(result.nadir_hz, 49.5);
  EXPECT_LT(result.nadir_hz, 49.505);  // the last one acts after 0.916 s, not 0.968 s
}

// Eq. (15) assumes that load is shed at once.
TEST(Scenario, ByThePapersRulesOutletsShedTheRequiredPowerTooLate) {
  const ScenarioResult result = simulate_by_papers_rules(Control::kGridSense);
  EXPECT_NEAR(result.required_mw, 148.08, 0.01);
  EXPECT_NEAR(result.shed.power_mw, result.required_mw, 0.01 * result.required_mw);
  EXPECT_GT(result.nadir_hz, 49.48);
  EXPECT_LT(result.nadir_hz, 49.49);
}

TEST(Scenario, NoOutletShedsForALossBelowTheThreshold) {
  EXPECT_LT(simulate_control(Control::kGridSense, 320.0).shed.power_mw, 0.1);
}

TEST(Scenario, ADelayAwareThresholdKeepsTheNadirAboveTheLimit) {
  const grid::SfrModel model(ieee24());
  const double threshold_mw = control_centre::threshold_for_delay_mw(model, 49.5, 500.0, 0.908);
  EXPECT_LT(threshold_mw, control_centre::threshold_mw(model, 49.5));
  EXPECT_NEAR(simulate_control(Control::kGridSense, 500.0, threshold_mw).nadir_hz, 49.501, 0.001);
}

// All f^B of eq. (17) are within 10 mHz below f_s.
TEST(Scenario, SwitchingOffFrequenciesOfEquation17ShedFarTooMuch) {
  const ScenarioResult result = simulate_by_papers_rules(Control::kSwitchOff);
  EXPECT_GT(result.first_action_s, 1.2);
  EXPECT_NEAR(result.shed.power_mw, 892.0, 5.0);  // 148 MW required, 906 MW in the fleet
}

TEST(Scenario, ACentralControllerShedsTheRequiredPowerTooLate) {
  const ScenarioResult result = simulate_control(Control::kCentral);
  EXPECT_NEAR(result.shed.power_mw, result.required_mw, 1e-6);
  EXPECT_DOUBLE_EQ(result.first_action_s, 1.9);
  EXPECT_LT(result.nadir_hz, simulate_control(Control::kGridSense).nadir_hz);
}

TEST(Scenario, RelaysActOnlyBelowTheirFrequency) {
  EXPECT_EQ(simulate_control(Control::kUfls).shed.power_mw, 0.0);
  const ScenarioResult result = simulate_control(Control::kUfls, 900.0);
  EXPECT_NEAR(result.shed.power_mw, 0.05 * ieee24().load_mw, 1e-6);  // one stage
  EXPECT_LT(result.nadir_hz, 49.0);
  EXPECT_GT(result.nadir_hz, 48.8);  // the frequency of the next stage
}

TEST(Scenario, IsTheSameOnAnyNumberOfThreads) {
  const ScenarioResult one = simulate_control(Control::kGridSense, 500.0, 0.0, 1);
  for (const std::size_t threads : {2U, 3U}) {
    const ScenarioResult other = simulate_control(Control::kGridSense, 500.0, 0.0, threads);
    EXPECT_EQ(other.shed.power_mw, one.shed.power_mw);
    EXPECT_EQ(other.nadir_hz, one.nadir_hz);
    EXPECT_EQ(other.shed.off_in_group, one.shed.off_in_group);
  }
}

TEST(Scenario, RejectsALossOutOfRange) {
  EXPECT_THROW(simulate_control(Control::kNone, 0.0), std::invalid_argument);
  EXPECT_THROW(simulate_control(Control::kNone, 1e5), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::fleet
