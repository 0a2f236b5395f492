#include "synthetic_case.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace gsbench::judge::test {
namespace {

using record::MeasurementResult;
using record::Verdict;

TEST(Judge, ConvertsValueAndLimitsToTheProfilesUnit) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.expectations = {limits("event.delay", {}, 0.16, "s")};
  const MeasurementResult result = measure(c.view()).front();
  EXPECT_EQ(result.unit, "s");
  EXPECT_NEAR(result.value, 0.120, 1e-12);
  EXPECT_NEAR(result.uncertainty, 0.4e-3, 1e-12);
  EXPECT_EQ(result.high, 0.16);
  EXPECT_TRUE(std::isnan(result.low));
  EXPECT_EQ(result.verdict, Verdict::kPass);
}

// The value is 120 ms ± 0.4 ms; the limits are in other units.
TEST(Judge, ConvertsUnitsBeforeComparing) {
  const SyntheticCase c = loss_of_500_mw();
  EXPECT_EQ(verdict(c, limits("event.delay", {}, 121000.0, "us")), Verdict::kPass);
  EXPECT_EQ(verdict(c, limits("event.delay", {}, 120100.0, "us")), Verdict::kInconclusive);
  EXPECT_EQ(verdict(c, limits("event.delay", {}, 119000.0, "us")), Verdict::kFail);
  EXPECT_EQ(verdict(c, limits("tracker.error.max", {}, 0.004, "Hz")), Verdict::kPass);
  EXPECT_EQ(verdict(c, limits("tracker.error.max", {}, 0.002, "Hz")), Verdict::kFail);
  EXPECT_EQ(verdict(c, limits("lse.loss", {}, 0.46, "GW")), Verdict::kPass);
  EXPECT_EQ(verdict(c, limits("lse.loss", {}, 440000.0, "kW")), Verdict::kFail);
}

TEST(Judge, NeverPassesALimitInAnIncompatibleUnit) {
  EXPECT_EQ(verdict(loss_of_500_mw(), limits("event.delay", {}, 1e9, "Hz")),
            Verdict::kInconclusive);
}

TEST(Judge, KeepsALimitOnAnUnknownMeasure) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.expectations = {limits("event.count", {}, 1.0), limits("event.taste", {}, 1.0)};
  judge_outlet(c.view(), c.outlet);
  EXPECT_EQ(c.outlet.verdict, Verdict::kInconclusive);
  EXPECT_EQ(c.outlet.measurements[1].name, "event.taste");
  EXPECT_EQ(c.outlet.measurements[1].reason, "unknown measure");
}

TEST(Judge, ListsJudgedMeasuresFirstThenAllOthersOnce) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.expectations = {limits("relay.edges", {}, 1.0), limits("event.count", {}, 1.0),
                         limits("relay.edges", {}, 2.0)};
  const std::vector<MeasurementResult> results = measure(c.view());
  ASSERT_EQ(results.size(), measures::catalogue().size() + 1);
  EXPECT_EQ(results[0].name, "relay.edges");
  EXPECT_EQ(results[0].high, 1.0);
  EXPECT_EQ(results[1].name, "event.count");
  EXPECT_EQ(results[2].name, "relay.edges");
  EXPECT_EQ(results[2].high, 2.0);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].judged, i < 3) << results[i].name;
    EXPECT_FALSE(results[i].definition.empty()) << results[i].name;
  }
}

// Reports [from, to) of the outlet, and its estimates with the first of them.
record::Reports piece_of(const record::OutletRecord& outlet, std::size_t from, std::size_t to) {
  record::Reports piece;
  const record::MeasurementTrace& trace = outlet.reports.trace;
  for (std::size_t i = from; i < std::min(to, trace.tick.size()); ++i) {
    record::append(trace, i, piece.trace);
  }
  if (from == 0) {
    piece.estimates = outlet.reports.estimates;
  }
  return piece;
}

TEST(Judge, MeasuresTracesInPiecesAsItDoesAtOnce) {
  const SyntheticCase synthetic = loss_of_500_mw();
  const std::vector<MeasurementResult> at_once = measure(synthetic.view());
  for (const std::size_t length : {1U, 7U, 100U}) {
    Case c{synthetic.plan, *synthetic.reference, synthetic.outlet, synthetic.uncertainty};
    for (std::size_t from = 0; from < synthetic.outlet.reports.trace.tick.size(); from += length) {
      c.add(piece_of(synthetic.outlet, from, from + length));
    }
    const std::vector<MeasurementResult> results = measure(c);
    ASSERT_EQ(results.size(), at_once.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_TRUE(results[i].value == at_once[i].value ||
                  (std::isnan(results[i].value) && std::isnan(at_once[i].value)))
          << results[i].name << " in pieces of " << length;
      EXPECT_EQ(results[i].reason, at_once[i].reason) << results[i].name;
    }
  }
}

TEST(Judge, GivesNoVerdictOnMeasuresWithoutLimits) {
  SyntheticCase c = loss_of_500_mw();
  c.remove_marks("lse");
  c.plan.expectations = {limits("event.count", {}, 1.0)};
  judge_outlet(c.view(), c.outlet);
  EXPECT_EQ(c.outlet.verdict, Verdict::kPass);
  const auto lse = std::find_if(c.outlet.measurements.begin(), c.outlet.measurements.end(),
                                [](const MeasurementResult& r) { return r.name == "lse.loss"; });
  ASSERT_NE(lse, c.outlet.measurements.end());
  EXPECT_EQ(lse->reason, "the outlet reported no least-squares estimate (LSE)");
}

TEST(Judge, AppliesALimitOnlyToItsGroups) {
  profile::Expectation of_others = limits("event.count", {}, 0.0);
  of_others.groups = {"others", "more"};
  SyntheticCase c = loss_of_500_mw();
  c.plan.expectations = {limits("event.count", {}, 1.0), of_others};
  judge_outlet(c.view(), c.outlet);
  EXPECT_EQ(c.outlet.verdict, Verdict::kPass);

  c = loss_of_500_mw();
  c.outlet.group = "more";
  c.plan.expectations = {limits("event.count", {}, 1.0), of_others};
  judge_outlet(c.view(), c.outlet);
  EXPECT_EQ(c.outlet.verdict, Verdict::kFail);
}

TEST(Judge, OutletWithoutLimitsIsInconclusive) {
  profile::Expectation of_others = limits("event.count", {}, 1.0);
  of_others.groups = {"others"};
  EXPECT_EQ(verdict(loss_of_500_mw(), of_others), Verdict::kInconclusive);
}

TEST(Judge, OutletGetsTheWorstVerdictOfItsMeasurements) {
  SyntheticCase c = loss_of_500_mw();
  // Inconclusive (120 ms ± 0.4), failed, passed.
  c.plan.expectations = {limits("event.delay", {}, 120.0), limits("event.count", {}, 0.0),
                         limits("relay.edges", {}, 1.0)};
  judge_outlet(c.view(), c.outlet);
  EXPECT_EQ(c.outlet.verdict, Verdict::kFail);
  EXPECT_EQ(c.outlet.measurements[0].verdict, Verdict::kInconclusive);
  EXPECT_EQ(c.outlet.measurements[1].verdict, Verdict::kFail);
  EXPECT_EQ(c.outlet.measurements[2].verdict, Verdict::kPass);
}

TEST(Judge, MissingMeasurementHasAReasonAndNoValue) {
  SyntheticCase c = loss_of_500_mw();
  c.remove_marks("lse");
  c.plan.expectations = {limits("lse.loss", {}, 1e9)};
  const MeasurementResult result = measure(c.view()).front();
  EXPECT_TRUE(std::isnan(result.value));
  EXPECT_EQ(result.reason, "the outlet reported no least-squares estimate (LSE)");
  EXPECT_EQ(result.verdict, Verdict::kFail);
}

}  // namespace
}  // namespace gsbench::judge::test
