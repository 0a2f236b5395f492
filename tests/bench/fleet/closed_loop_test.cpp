// The whole firmware, starting from the sampled voltage; the load that it sheds acts back on the
// frequency.
#include <test_support/ieee24.hpp>

#include <gtest/gtest.h>

#include <fleet/closed_loop.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;

ClosedLoopResult simulate_loop(double loss_mw, double threshold_mw, std::size_t threads = 2) {
  FleetOptions few;
  few.groups = 100;
  few.per_group = 1;
  few.least_w = 1e5;
  few.most_w = 1.8e7;
  ClosedLoopOptions options;
  options.loss_mw = loss_mw;
  options.threshold_mw = threshold_mw;
  options.duration_s = 2.0;
  Execution execution;
  execution.threads = threads;
  return simulate_closed_loop(test::ieee24(), make_fleet(few), options, execution).value();
}

// The fleet has a hundred blocks of up to 18 MW, so that the power shed is right within half a
// block.
constexpr double kHalfBlock_mw = 9.0;

TEST(ClosedLoop, EveryOutletDetectsTheLossAndTheFleetShedsTheRequiredPower) {
  const ClosedLoopResult result = simulate_loop(500.0, 0.0);
  EXPECT_EQ(result.events, 100U);
  EXPECT_EQ(result.false_events, 0U);
  EXPECT_GT(result.latest_event_s, 0.10);
  EXPECT_LT(result.latest_event_s, 0.16);
  EXPECT_EQ(result.loss_mw.count(), 100);
  EXPECT_NEAR(result.loss_mw.mean(), 500.0, 5.0);
  EXPECT_NEAR(result.scenario.shed.power_mw, result.scenario.required_mw, kHalfBlock_mw);
  EXPECT_GT(result.scenario.first_action_s, 0.85);
  EXPECT_LT(result.scenario.last_action_s, 0.96);
}

TEST(ClosedLoop, ALowerThresholdIncreasesThePowerShed) {
  EXPECT_NEAR(simulate_loop(500.0, 200.0).scenario.shed.power_mw, 300.0, kHalfBlock_mw);
}

TEST(ClosedLoop, NoOutletShedsForALossBelowTheThreshold) {
  const ClosedLoopResult result = simulate_loop(300.0, 0.0);
  EXPECT_EQ(result.events, 100U);
  EXPECT_NEAR(result.loss_mw.mean(), 300.0, 5.0);
  EXPECT_EQ(result.scenario.shed.outlets, 0U);
}

TEST(ClosedLoop, IsTheSameOnAnyNumberOfThreads) {
  const ClosedLoopResult one = simulate_loop(500.0, 0.0, 1);
  const ClosedLoopResult three = simulate_loop(500.0, 0.0, 3);
  EXPECT_EQ(three.scenario.shed.outlets, one.scenario.shed.outlets);
  EXPECT_EQ(three.scenario.nadir_hz, one.scenario.nadir_hz);
  EXPECT_EQ(three.loss_mw.mean(), one.loss_mw.mean());
}

}  // namespace
}  // namespace gsbench::fleet
