// The whole firmware, starting from the sampled voltage; the load that it sheds acts back on the
// frequency. Beside it, other controls of the same load.
#include <test_support/ieee24.hpp>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fleet/closed_loop.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using profile::Plan;
using test::ieee24;

constexpr double kLoss_s = 1.0;
// The fleet has a hundred blocks of up to 18 MW, so that the power shed is right within half a
// block.
constexpr double kHalfBlock_mw = 9.0;

const Fleet& hundred_outlets() {
  static const Fleet fleet = [] {
    FleetOptions few;
    few.groups = 100;
    few.per_group = 1;
    few.least_w = 1e5;
    few.most_w = 1.8e7;
    return make_fleet(few);
  }();
  return fleet;
}

Plan plan_of(double loss_mw) {
  return plan_of_loss(ieee24(), loss_mw, kLoss_s, 1.0, 1);
}

ClosedLoopResult simulate_loop(const Plan& plan, Strategy strategy, double after_loss_s = 8.0,
                               double threshold_mw = 0.0, std::size_t threads = 2) {
  ClosedLoopOptions options;
  options.after_loss_s = after_loss_s;
  options.threshold_mw = threshold_mw;
  Execution execution;
  execution.threads = threads;
  return simulate_closed_loop(plan, hundred_outlets(), strategy, options, execution).value();
}

TEST(ClosedLoop, EveryOutletDetectsTheLossAndThePaperShedsTheRequiredPower) {
  const ClosedLoopResult result = simulate_loop(plan_of(500.0), Strategy::kPaper, 2.0);
  const OutletActions& outlets = result.outlets.value();
  EXPECT_EQ(outlets.events, 100U);
  EXPECT_EQ(outlets.false_events, 0U);
  EXPECT_GT(outlets.latest_event_s.value(), kLoss_s + 0.10);
  EXPECT_LT(outlets.latest_event_s.value(), kLoss_s + 0.16);
  EXPECT_EQ(outlets.loss_mw.count(), 100);
  EXPECT_NEAR(outlets.loss_mw.mean(), 500.0, 5.0);
  EXPECT_NEAR(result.shed_mw, 148.08, kHalfBlock_mw);
  EXPECT_GT(result.first_action_s.value(), kLoss_s + 0.85);
  EXPECT_LT(result.last_action_s.value(), kLoss_s + 0.96);
}

TEST(ClosedLoop, ALowerThresholdIncreasesThePowerShedAsThePaperDoes) {
  EXPECT_NEAR(simulate_loop(plan_of(500.0), Strategy::kPaper, 2.0, 200.0).shed_mw, 300.0,
              kHalfBlock_mw);
}

TEST(ClosedLoop, NoOutletShedsForALossBelowTheThreshold) {
  for (const Strategy strategy : {Strategy::kPaper, Strategy::kGsbench}) {
    const ClosedLoopResult result = simulate_loop(plan_of(300.0), strategy, 2.0);
    EXPECT_EQ(result.outlets.value().events, 100U);
    EXPECT_EQ(result.outlets.value().off, 0U);
    EXPECT_EQ(result.shed_mw, 0.0);
    EXPECT_FALSE(result.first_action_s.has_value());
  }
}

// Without control the frequency is that of the model; with outlets the shed load raises the nadir.
TEST(ClosedLoop, ShedLoadRaisesTheNadirAndTheEnd) {
  const ClosedLoopResult none = simulate_loop(plan_of(500.0), Strategy::kNone);
  EXPECT_NEAR(none.nadir_hz, 49.290, 0.001);
  EXPECT_NEAR(none.nadir_s, kLoss_s + 3.761, 0.003);
  EXPECT_FALSE(none.outlets.has_value());
  const ClosedLoopResult gsbench = simulate_loop(plan_of(500.0), Strategy::kGsbench);
  EXPECT_GT(gsbench.nadir_hz, 49.49);
  EXPECT_LT(gsbench.nadir_hz, 49.53);
  EXPECT_GT(gsbench.end_hz, none.end_hz + 0.08);
  EXPECT_LT(gsbench.end_hz, none.end_hz + 0.25);
}

TEST(ClosedLoop, ADipAloneShedsNothing) {
  Plan plan = plan_of(500.0);
  plan.stimulus.losses.clear();
  plan.stimulus.duration_s = 4.0;
  plan.stimulus.signal.amplitude_steps = {{1.5, 0.1, 40.0}};
  for (const Strategy strategy : all_strategies()) {
    const ClosedLoopResult result = simulate_loop(plan, strategy);
    EXPECT_EQ(result.shed_mw, 0.0) << to_string(strategy);
    EXPECT_EQ(result.nadir_hz, 50.0);
    EXPECT_NEAR(result.t_s.back(), 4.0, 0.001);
  }
}

std::optional<std::size_t> false_events(const Plan& plan) {
  return simulate_loop(plan, Strategy::kPaper, 1.0).outlets.value().false_events;
}

// Power that returns raises the frequency, which falls again from its peak.
TEST(ClosedLoop, ClaimsBeforeTheFirstLossAreFalseEvents) {
  Plan plan = plan_of(500.0);
  plan.stimulus.losses = {{1.0, -2500.0}};
  plan.stimulus.duration_s = 9.0;
  EXPECT_EQ(false_events(plan), 100U);
  plan.stimulus.losses.push_back({8.9, 500.0});
  EXPECT_EQ(false_events(plan), 100U);
  plan.stimulus.losses = {{0.9, 1.0}, {1.0, -2500.0}};
  EXPECT_EQ(false_events(plan), 0U);
}

TEST(ClosedLoop, FalseEventsOfARecordedFrequencyAreNotKnown) {
  Plan plan = plan_of(500.0);
  plan.stimulus.losses.clear();
  plan.stimulus.duration_s = 3.0;
  plan.stimulus.points = {{0.0, 50.0, 1.0}, {1.0, 50.0, 1.0}, {2.0, 49.5, 1.0}};
  EXPECT_EQ(false_events(plan), std::nullopt);
  plan.stimulus.points = {{0.0, 49.9, 1.0}, {2.0, 49.9, 1.0}};
  EXPECT_EQ(false_events(plan), 0U);
}

struct Known {
  Strategy strategy;
  double shed_mw;
  double action_s;  // after the loss
};

// The figures of a search in steps of 4 ms, which acts up to one step of 16 ms later.
TEST(ClosedLoop, ClairvoyantsKeepTheThresholdWithTheLeastPower) {
  for (const Known& known : {Known{Strategy::kClairvoyant300ms, 148.9, 0.3},
                             Known{Strategy::kClairvoyant500ms, 150.4, 0.5},
                             Known{Strategy::kClairvoyant750ms, 154.2, 0.75},
                             Known{Strategy::kClairvoyant960ms, 159.8, 0.96}}) {
    const ClosedLoopResult result = simulate_loop(plan_of(500.0), known.strategy);
    EXPECT_NEAR(result.shed_mw, known.shed_mw, 0.4) << to_string(known.strategy);
    EXPECT_NEAR(result.nadir_hz, 49.5, 1e-6);
    EXPECT_GE(result.first_action_s.value(), kLoss_s + known.action_s);
    EXPECT_LT(result.last_action_s.value(), kLoss_s + known.action_s + 0.017);
  }
}

// 300 MW from 49.85 Hz have a nadir of 49.424 Hz. The figure is of a search in steps of 4 ms.
TEST(ClosedLoop, AFrequencyBeforeTheStartStaysAndAddsToTheResponse) {
  Plan plan = plan_of(300.0);
  plan.stimulus.initial_deviation_hz = -0.15;
  EXPECT_NEAR(simulate_loop(plan, Strategy::kNone).nadir_hz, 49.424, 0.001);
  const ClosedLoopResult result = simulate_loop(plan, Strategy::kClairvoyant500ms);
  EXPECT_NEAR(result.shed_mw, 54.2, 0.4);
  EXPECT_NEAR(result.nadir_hz, 49.5, 1e-6);
}

TEST(ClosedLoop, OscillationsAreSeenByOutletsButAreNotOfTheGridModel) {
  Plan plan = plan_of(500.0);
  plan.stimulus.losses.clear();
  plan.stimulus.duration_s = 6.0;
  plan.stimulus.noise_pct = 0.0;
  plan.stimulus.oscillations.resize(1);
  plan.stimulus.oscillations[0].frequency_hz = 0.5;
  plan.stimulus.oscillations[0].amplitude_hz = 0.2;  // the slope is that of 1000 MW
  EXPECT_GT(false_events(plan), 90U);
  for (const Strategy strategy : {Strategy::kNone, Strategy::kClairvoyant300ms}) {
    const ClosedLoopResult result = simulate_loop(plan, strategy);
    EXPECT_EQ(result.nadir_hz, 50.0);
    EXPECT_EQ(result.shed_mw, 0.0);
  }
}

TEST(ClosedLoop, SettingsThatAreSentAgainDuringTheEventChangeNothing) {
  Plan plan = plan_of(500.0);
  const ClosedLoopResult without = simulate_loop(plan, Strategy::kGsbench, 3.0);
  for (const double at_s : {kLoss_s + 0.3, kLoss_s + 0.6}) {
    plan.settings.push_back({at_s, {}, {}});
  }
  const ClosedLoopResult with = simulate_loop(plan, Strategy::kGsbench, 3.0);
  EXPECT_GT(without.shed_mw, 100.0);
  EXPECT_EQ(with.shed_mw, without.shed_mw);
  EXPECT_EQ(with.first_action_s, without.first_action_s);
}

TEST(ClosedLoop, AClairvoyantDoesNotShedForALossThatComesBackInTime) {
  Plan plan = plan_of(600.0);
  plan.stimulus.losses.push_back({kLoss_s + 0.4, -600.0});
  EXPECT_EQ(simulate_loop(plan, Strategy::kClairvoyant500ms).shed_mw, 0.0);
  EXPECT_GT(simulate_loop(plan, Strategy::kClairvoyant300ms).shed_mw, 200.0);
}

TEST(ClosedLoop, TheControllerShedsTheExcessOfACascadeAfterItsDelay) {
  const ClosedLoopResult one = simulate_loop(plan_of(500.0), Strategy::kCentral);
  EXPECT_NEAR(one.shed_mw, 148.08, 0.01);
  EXPECT_NEAR(one.first_action_s.value(), kLoss_s + 1.9, 1e-6);
  Plan plan = plan_of(400.0);
  plan.stimulus.losses.push_back({kLoss_s + 1.0, 100.0});
  const ClosedLoopResult two = simulate_loop(plan, Strategy::kCentral);
  EXPECT_NEAR(two.shed_mw, 148.08, 0.01);
  EXPECT_NEAR(two.first_action_s.value(), kLoss_s + 1.9, 1e-6);
  EXPECT_NEAR(two.last_action_s.value(), kLoss_s + 2.9, 1e-6);
}

TEST(ClosedLoop, RelaysActOnlyBelowTheirFrequency) {
  EXPECT_EQ(simulate_loop(plan_of(500.0), Strategy::kUfls).shed_mw, 0.0);
  const ClosedLoopResult result = simulate_loop(plan_of(900.0), Strategy::kUfls);
  EXPECT_NEAR(result.shed_mw, 0.05 * ieee24().load_mw, 1e-6);  // one stage
  EXPECT_LT(result.nadir_hz, 49.0);
  EXPECT_GT(result.nadir_hz, 48.8);  // the frequency of the next stage
}

TEST(ClosedLoop, ARecordedFrequencyHasNoKnownLoss) {
  Plan plan = plan_of(500.0);
  plan.stimulus.losses.clear();
  plan.stimulus.points = {{0.0, 50.0, 1.0}, {3.0, 49.0, 1.0}};
  EXPECT_TRUE(is_possible(plan, Strategy::kPaper));
  EXPECT_FALSE(is_possible(plan, Strategy::kCentral));
  EXPECT_FALSE(is_possible(plan, Strategy::kClairvoyant300ms));
  EXPECT_THROW(simulate_loop(plan, Strategy::kClairvoyant300ms), std::invalid_argument);
}

TEST(ClosedLoop, IsTheSameOnAnyNumberOfThreads) {
  for (const Strategy strategy : {Strategy::kPaper, Strategy::kGsbench}) {
    const ClosedLoopResult one = simulate_loop(plan_of(500.0), strategy, 2.0, 0.0, 1);
    const ClosedLoopResult three = simulate_loop(plan_of(500.0), strategy, 2.0, 0.0, 3);
    EXPECT_GT(one.shed_mw, 0.0);
    EXPECT_EQ(three.shed_mw, one.shed_mw);
    EXPECT_EQ(three.frequency_hz, one.frequency_hz);
    EXPECT_EQ(three.outlets.value().loss_mw.mean(), one.outlets.value().loss_mw.mean());
  }
}

TEST(ClosedLoop, TheSeedChangesTheNoiseOfTheOutlets) {
  Plan plan = plan_of(500.0);
  const double first_mw = simulate_loop(plan, Strategy::kPaper, 2.0).outlets.value().loss_mw.mean();
  plan.seed = 2;
  EXPECT_NE(simulate_loop(plan, Strategy::kPaper, 2.0).outlets.value().loss_mw.mean(), first_mw);
}

TEST(ClosedLoop, RejectsOptionsOutOfRange) {
  EXPECT_THROW(plan_of(0.0), std::invalid_argument);
  EXPECT_THROW(plan_of(1e5), std::invalid_argument);
  EXPECT_THROW(simulate_loop(plan_of(500.0), Strategy::kNone, 0.5), std::invalid_argument);
  Plan plan = plan_of(500.0);
  plan.stimulus.sample_rate_hz = 64000;  // beyond the firmware's
  EXPECT_THROW(simulate_loop(plan, Strategy::kPaper), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::fleet
