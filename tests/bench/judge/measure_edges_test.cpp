// Boundary cases of the definitions in the catalogue.

#include "synthetic_case.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace gsbench::judge::test {
namespace {

using Edge = std::pair<std::int64_t, bool>;

// A record with only these edges at the relay sense.
SyntheticCase with_edges(const std::vector<Edge>& edges) {
  SyntheticCase c = loss_of_500_mw();
  c.remove_marks("relay.sense");
  for (const auto& [tick, closed] : edges) {
    c.add_mark(tick, "relay.sense", closed ? 1.0 : 0.0);
  }
  return c;
}

void expect_contact(const SyntheticCase& c, double edges, double chatter, const char* end) {
  EXPECT_EQ(c.read("relay.edges").value, edges);
  EXPECT_EQ(c.read("relay.chatter").value, chatter);
  EXPECT_EQ(c.read("relay.end").text, end);
}

TEST(Contact, IsClosedWithoutEdges) {
  expect_contact(with_edges({}), 0.0, 0.0, "closed");
}

TEST(Contact, CountsBouncesAsOneChangeAndAsChatter) {
  const SyntheticCase c =
      with_edges({{4000, false}, {5000, true}, {5001, false}, {5003, true}, {5013, true}});
  expect_contact(c, 2.0, 3.0, "closed");
}

TEST(Contact, SeparatesChangesMoreThanTenMillisecondsApart) {
  expect_contact(with_edges({{4000, false}, {4010, true}}), 0.0, 2.0, "closed");
  expect_contact(with_edges({{4000, false}, {4011, true}}), 2.0, 0.0, "closed");
}

TEST(Contact, CountsABurstWithoutALastingChangeAsChatterOnly) {
  const SyntheticCase c = with_edges({{4000, false}, {4002, true}, {5000, false}});
  expect_contact(c, 1.0, 2.0, "open");
  EXPECT_EQ(c.read("trip.time").value, 5.0) << "a short interruption is not an opening";
}

TEST(Contact, ChangesAtItsFirstEdge) {
  const SyntheticCase c = with_edges({{4000, false}, {4001, true}, {4002, false}});
  EXPECT_EQ(c.read("trip.time").value, 4.0);
}

TEST(Relay, DelayStartsAtTheLossAndTripTimeAtTheStart) {
  const SyntheticCase c = with_edges({{1000, false}, {2000, true}, {3500, false}});
  EXPECT_NEAR(c.read("relay.delay").value, 500.0, 1e-9);
  EXPECT_EQ(c.read("trip.time").value, 1.0);
}

TEST(Relay, ReportDifferenceIsNegativeIfTheContactOpensFirst) {
  const SyntheticCase c = with_edges({{3910, false}});
  EXPECT_NEAR(c.read("relay.report_difference").value, -10.0, 1e-9);
}

// A relay that opens at its highest permitted frequency, in steady frequency.
TEST(Relay, OperateFrequencyIsAsUncertainAsThePlayedFrequency) {
  SyntheticCase c = with_edges({{1000, false}});
  c.uncertainty.frequency_mhz = 1.5;
  const Reading opened = c.read("relay.operate_hz");
  EXPECT_EQ(opened.value, 50.0);
  EXPECT_NEAR(opened.uncertainty, 1.5e-3, 1e-12);
  EXPECT_EQ(verdict(c, limits("relay.operate_hz", std::nullopt, 50.0)),
            record::Verdict::kInconclusive);
  EXPECT_EQ(verdict(c, limits("relay.operate_hz", std::nullopt, 50.0016)), record::Verdict::kPass);
  EXPECT_EQ(verdict(c, limits("relay.operate_hz", std::nullopt, 49.998)), record::Verdict::kFail);
}

TEST(Relay, CommandDelayEndsAtTheCommandedChange) {
  SyntheticCase c = commanded();
  c.remove_marks("command");
  c.add_mark(3000, "command", 1.0, "switch on");
  c.add_mark(3020, "relay.sense", 1.0);
  EXPECT_NEAR(c.read("command.delay").value, 20.0, 1e-9);
}

TEST(DecisionCause, IsThatOfTheFirstReportedOpening) {
  SyntheticCase c = loss_of_500_mw();
  c.add_mark(1000, "relay.reported", 1.0, "none");
  EXPECT_EQ(c.read("decision.cause").text, "loss");
  c.add_mark(1500, "relay.reported", 0.0, "frequency");
  EXPECT_EQ(c.read("decision.cause").text, "frequency");
}

TEST(DecisionCause, IsNoneWithoutAReportedOpening) {
  SyntheticCase c = loss_of_500_mw();
  c.remove_marks("relay.reported");
  EXPECT_EQ(c.read("decision.cause").text, "none");
}

// The reference falls by 0.4 Hz/s from 3 s and the declared delay is 28 ms: half of the threshold
// of 20 mHz is reached 53 ms after the loss.
TEST(FalseEvent, IsCountedIfTheReferenceFellByLessThanHalfTheThreshold) {
  for (const auto& [tick, is_false] : std::vector<std::pair<std::int64_t, double>>{
           {10, 1.0}, {2999, 1.0}, {3050, 1.0}, {3056, 0.0}, {4400, 0.0}}) {
    SyntheticCase c = loss_of_500_mw();
    c.remove_marks("event");
    c.add_mark(tick, "event", 50.0);
    EXPECT_EQ(c.read("event.false").value, is_false) << tick;
  }
}

TEST(FalseEvent, LooksBackForHalfASecond) {
  SyntheticCase c = loss_of_500_mw();
  c.remove_marks("event");
  // The fall ended more than half a second before.
  c.add_mark(4700, "event", 49.6);
  EXPECT_EQ(c.read("event.false").value, 1.0);
}

TEST(FalseEvent, DependsOnTheOutletsThreshold) {
  SyntheticCase c = loss_of_500_mw();
  // The reference has fallen by 36.8 mHz at the event.
  c.outlet.settings["event_drop_hz"] = 0.073;
  EXPECT_EQ(c.read("event.false").value, 0.0);
  c.outlet.settings["event_drop_hz"] = 0.074;
  EXPECT_EQ(c.read("event.false").value, 1.0);
}

double dead_bus_claims(double from_s, double duration_s, double level_pct) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.signal.amplitude_steps = {{from_s, duration_s, level_pct}};
  return c.read("validity.dead_bus_claims").value;
}

TEST(DeadBusClaims, CountFromSixtyMillisecondsAfterTheVoltageLoss) {
  // Reports at 2.064 s … 2.992 s, every 16 ms.
  EXPECT_EQ(dead_bus_claims(2.0, 1.0, 0.0), 59.0);
  EXPECT_EQ(dead_bus_claims(2.0, 0.06, 0.0), 0.0);
}

TEST(DeadBusClaims, CountBelowTenPercentAndNotAtTenPercent) {
  EXPECT_EQ(dead_bus_claims(2.0, 1.0, 9.9), 59.0);
  EXPECT_EQ(dead_bus_claims(2.0, 1.0, 10.0), 0.0);
}

TEST(DeadBusClaims, ContinueToTheEndIfTheVoltageDoesNotRecover) {
  // 2.064 s … 5.984 s.
  EXPECT_EQ(dead_bus_claims(2.0, std::numeric_limits<double>::infinity(), 0.0), 246.0);
}

TEST(DeadBusClaims, MultiplyOverlappingSteps) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.signal.amplitude_steps = {{2.0, 1.0, 30.0}, {2.0, 1.0, 30.0}};
  EXPECT_EQ(c.read("validity.dead_bus_claims").value, 59.0);
}

TEST(DeadBusClaims, ExcludeInvalidReports) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.signal.amplitude_steps = {{2.0, 1.0, 0.0}};
  for (std::uint8_t& validity : c.outlet.reports.trace.validity) {
    validity = validity == 1 ? 2 : validity;
  }
  EXPECT_EQ(c.read("validity.dead_bus_claims").value, 0.0);
}

TEST(LostPower, IsTheSumOfAllLossesSoFar) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.losses = {{3.0, 600.0}, {3.1, -150.0}, {3.28, 50.0}, {3.281, 1000.0}};
  // 600 − 150 + 50 at 3.280 s, where the LSE is 450 MW.
  EXPECT_NEAR(c.read("lse.error").value, -10.0, 1e-9);
}

TEST(FirstLoss, IsTheEarliestPositiveLoss) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.losses = {{3.1, 100.0}, {3.05, 100.0}, {2.0, -50.0}};
  EXPECT_NEAR(c.read("event.delay").value, 70.0, 1e-9);
}

TEST(FirstLoss, IsNoneWithoutLosses) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.losses.clear();
  EXPECT_FALSE(c.view().first_loss_tick().has_value());
}

// 0.017 s · 6000 Hz is 102.00000000000001 in doubles; the source plays the loss from tick 102.
TEST(FirstLoss, IsAtTheFirstTickThatTheSourcePlays) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.sample_rate_hz = 6000;
  c.plan.stimulus.losses = {{0.017, 500.0}};
  EXPECT_EQ(c.view().first_loss_tick(), 102);
  EXPECT_EQ(c.view().lost_mw(101), 0.0);
  EXPECT_EQ(c.view().lost_mw(102), 500.0);
}

TEST(FirstLoss, IsTheStartOfARampThatIsLostInProportionToTime) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.stimulus.sample_rate_hz = 8000;
  c.plan.stimulus.losses = {{3.0, 500.0, 2.0}};
  EXPECT_EQ(c.view().first_loss_tick(), 24000);
  EXPECT_EQ(c.view().lost_mw(24000), 0.0);
  EXPECT_EQ(c.view().lost_mw(28000), 125.0);
  EXPECT_EQ(c.view().lost_mw(40000), 500.0);
  EXPECT_EQ(c.view().lost_mw(50000), 500.0);
}

TEST(TrackerError, IsRelativeToTheReferenceAtTheStampIfNoDelayIsDeclared) {
  SyntheticCase c = loss_of_500_mw();
  c.outlet.settings.erase("tracker_delay_s");
  // 28 ms at 0.4 Hz/s, in addition to 1 mHz and 2 mHz.
  EXPECT_NEAR(c.read("tracker.error.max").value, 11.2 + 3.0, 0.01);
}

}  // namespace
}  // namespace gsbench::judge::test
