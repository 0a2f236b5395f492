#include "synthetic_case.hpp"

#include <gtest/gtest.h>

namespace gsbench::judge::test {
namespace {

using record::Verdict;

// Two outlets of which at most one event is expected; the second has two, so that it fails.
struct TwoOutlets {
  profile::Plan plan;
  record::RunRecord run;

  TwoOutlets() {
    SyntheticCase c = loss_of_500_mw();
    plan = c.plan;
    plan.stimulus.kind = profile::TruthKind::kPoints;
    plan.stimulus.points = {{0.0, 50.0}, {6.0, 50.0}};
    expect_events(1.0);
    run.outlets.push_back(c.outlet);
    c.add_mark(3200, "event", 50.0);
    c.outlet.id = "outlet-2";
    run.outlets.push_back(c.outlet);
  }

  void expect_events(double max) { plan.expectations = {limits("event.count", {}, max)}; }

  void expect_error(const std::string& reason) {
    judge(plan, run);
    EXPECT_EQ(run.verdict, Verdict::kError);
    EXPECT_EQ(run.verdict_reason, reason);
    for (const record::OutletRecord& outlet : run.outlets) {
      EXPECT_EQ(outlet.verdict, Verdict::kError);
      EXPECT_TRUE(outlet.measurements.empty());
    }
  }
};

TEST(RunVerdict, IsThatOfTheWorstOutlet) {
  TwoOutlets two;
  judge(two.plan, two.run);
  EXPECT_EQ(two.run.outlets[0].verdict, Verdict::kPass);
  EXPECT_EQ(two.run.outlets[1].verdict, Verdict::kFail);
  EXPECT_EQ(two.run.verdict, Verdict::kFail);
  EXPECT_EQ(two.run.verdict_reason, "1 of 2 outlets did not pass");
}

TEST(RunVerdict, DoesNotDependOnAnEarlierOne) {
  TwoOutlets two;
  two.run.verdict = Verdict::kError;
  two.run.verdict_reason = "of before";
  two.run.outlets[0].verdict = Verdict::kError;
  two.expect_events(2.0);
  judge(two.plan, two.run);
  EXPECT_EQ(two.run.outlets[0].verdict, Verdict::kPass);
  EXPECT_EQ(two.run.verdict, Verdict::kPass);
  EXPECT_EQ(two.run.verdict_reason, "");
  two.expect_events(0.0);
  judge(two.plan, two.run);
  EXPECT_EQ(two.run.verdict, Verdict::kFail);
  EXPECT_EQ(two.run.verdict_reason, "2 of 2 outlets did not pass");
}

TEST(RunVerdict, OfAFaultyOutletIsErrorThoughItIsMeasured) {
  TwoOutlets two;
  two.run.outlets[0].fault = "fell silent";
  judge(two.plan, two.run);
  EXPECT_EQ(two.run.outlets[0].verdict, Verdict::kError);
  EXPECT_EQ(two.run.outlets[0].measurements.front().verdict, Verdict::kPass);
  EXPECT_EQ(two.run.outlets[1].verdict, Verdict::kFail);
  EXPECT_EQ(two.run.verdict, Verdict::kError);
  EXPECT_EQ(two.run.verdict_reason, "2 of 2 outlets did not pass: outlet outlet-1 fell silent");
}

TEST(RunVerdict, OfAnOutletThatTookNoPartIsErrorAndNothingOfItIsMeasured) {
  TwoOutlets two;
  two.run.outlets[0].took_part = false;
  judge(two.plan, two.run);
  EXPECT_EQ(two.run.outlets[0].verdict, Verdict::kError);
  EXPECT_TRUE(two.run.outlets[0].measurements.empty());
  EXPECT_EQ(two.run.verdict, Verdict::kError);
}

TEST(RunVerdict, OfAFaultOfTheBenchIsErrorForAll) {
  TwoOutlets two;
  judge(two.plan, two.run);
  two.run.fault = "the source is gone";
  two.expect_error("the source is gone");
}

TEST(RunVerdict, OfAnInterruptedRunIsErrorForAll) {
  TwoOutlets two;
  judge(two.plan, two.run);
  two.run.interrupted = true;
  two.expect_error("interrupted before its end");
}

TEST(RunVerdict, WithoutOutletsIsError) {
  TwoOutlets two;
  two.run.outlets.clear();
  two.expect_error("the run has no outlets");
}

}  // namespace
}  // namespace gsbench::judge::test
