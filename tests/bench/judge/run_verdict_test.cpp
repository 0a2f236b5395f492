#include "synthetic_case.hpp"

#include <gtest/gtest.h>

namespace gsbench::judge::test {
namespace {

using record::Verdict;

// Two outlets with a limit of one event; the second one has two events and fails.
class RunVerdict : public testing::Test {
 protected:
  RunVerdict() {
    SyntheticCase c = loss_of_500_mw();
    plan_ = c.plan;
    plan_.stimulus.losses.clear();
    plan_.stimulus.points = {{0.0, 50.0}, {6.0, 50.0}};
    expect_events(1.0);
    run_.outlets.push_back(c.outlet);
    c.add_mark(3200, "event", 50.0);
    c.outlet.id = "outlet-2";
    run_.outlets.push_back(c.outlet);
  }

  void expect_events(double max) { plan_.expectations = {limits("event.count", {}, max)}; }

  void expect_error(const std::string& reason) {
    judge(plan_, run_);
    EXPECT_EQ(run_.verdict, Verdict::kError);
    EXPECT_EQ(run_.verdict_reason, reason);
    for (const record::OutletRecord& outlet : run_.outlets) {
      EXPECT_EQ(outlet.verdict, Verdict::kError);
      EXPECT_TRUE(outlet.measurements.empty());
    }
  }

  profile::Plan plan_;
  record::RunRecord run_;
};

TEST_F(RunVerdict, IsThatOfTheWorstOutlet) {
  judge(plan_, run_);
  EXPECT_EQ(run_.outlets[0].verdict, Verdict::kPass);
  EXPECT_EQ(run_.outlets[1].verdict, Verdict::kFail);
  EXPECT_EQ(run_.verdict, Verdict::kFail);
  EXPECT_EQ(run_.verdict_reason, "1 of 2 outlets did not pass");
}

TEST_F(RunVerdict, DoesNotDependOnAnEarlierVerdict) {
  run_.verdict = Verdict::kError;
  run_.verdict_reason = "an earlier reason";
  run_.outlets[0].verdict = Verdict::kError;
  expect_events(2.0);
  judge(plan_, run_);
  EXPECT_EQ(run_.outlets[0].verdict, Verdict::kPass);
  EXPECT_EQ(run_.verdict, Verdict::kPass);
  EXPECT_EQ(run_.verdict_reason, "");
  expect_events(0.0);
  judge(plan_, run_);
  EXPECT_EQ(run_.verdict, Verdict::kFail);
  EXPECT_EQ(run_.verdict_reason, "2 of 2 outlets did not pass");
}

TEST_F(RunVerdict, IsErrorIfAnOutletIsFaultyAlthoughItIsMeasured) {
  run_.outlets[0].fault = "stopped reporting";
  judge(plan_, run_);
  EXPECT_EQ(run_.outlets[0].verdict, Verdict::kError);
  EXPECT_EQ(run_.outlets[0].measurements.front().verdict, Verdict::kPass);
  EXPECT_EQ(run_.outlets[1].verdict, Verdict::kFail);
  EXPECT_EQ(run_.verdict, Verdict::kError);
  EXPECT_EQ(run_.verdict_reason, "2 of 2 outlets did not pass: outlet outlet-1 stopped reporting");
}

TEST_F(RunVerdict, IsErrorIfAnOutletIsExcludedAndItIsNotMeasured) {
  run_.outlets[0].took_part = false;
  judge(plan_, run_);
  EXPECT_EQ(run_.outlets[0].verdict, Verdict::kError);
  EXPECT_TRUE(run_.outlets[0].measurements.empty());
  EXPECT_EQ(run_.verdict, Verdict::kError);
}

TEST_F(RunVerdict, IsErrorForAllOutletsIfTheBenchFails) {
  judge(plan_, run_);
  run_.fault = "the source is gone";
  expect_error("the source is gone");
}

TEST_F(RunVerdict, IsErrorForAllOutletsIfTheRunIsInterrupted) {
  judge(plan_, run_);
  run_.interrupted = true;
  expect_error("interrupted before its end");
}

TEST_F(RunVerdict, IsErrorWithoutOutlets) {
  run_.outlets.clear();
  expect_error("the run has no outlets");
}

}  // namespace
}  // namespace gsbench::judge::test
