// A run's file contains the record that the run returned. Judging that file again gives the same
// verdicts.

#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/temporary_folder.hpp>

#include <atomic>

#include <gtest/gtest.h>

#include <judge/judge.hpp>
#include <judge/plan_of.hpp>
#include <record/store.hpp>
#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

void clear_verdicts(record::RunRecord& run) {
  run.verdict = record::Verdict::kPass;
  run.verdict_reason.clear();
  for (record::OutletRecord& outlet : run.outlets) {
    outlet.verdict = record::Verdict::kPass;
    outlet.measurements.clear();
  }
}

record::Verdict verdict_when_judged_again(const profile::Plan& plan, Station& station,
                                          const std::atomic<bool>* stop = nullptr) {
  const gsbench::test::TemporaryFolder folder;
  const std::string path = folder.file("record.sqlite");
  record::RunRecord returned;
  {
    record::Writer writer(path);
    RunOptions options;
    options.writer = &writer;
    options.stop = stop;
    returned = run(plan, station, options);
  }
  record::RunRecord record = record::read_run(path);
  EXPECT_EQ(record.run_id, returned.run_id);
  EXPECT_EQ(record.finished_utc, returned.finished_utc);
  const std::string digest = record::content_digest(record);
  EXPECT_EQ(returned.content_sha256, digest);
  EXPECT_EQ(record.content_sha256, digest);
  clear_verdicts(record);
  EXPECT_NE(record::content_digest(record), digest);
  judge::judge(judge::plan_of(record), record);
  EXPECT_EQ(record::content_digest(record), digest);
  return record.verdict;
}

TEST(JudgedAgain, RunWithALossAndNoiseHasTheSameVerdicts) {
  const profile::Plan plan =
      test::plan(4.5, "noise_pct = 1.0\n[[grid.loss]]\nat_s = 2.0\npower_mw = 500.0\n",
                 "[[outlet]]\ncount = 2\naccumulated_mw = 100.0\n");
  EXPECT_EQ(verdict_when_judged_again(plan, *simulated_station(plan, {})), record::Verdict::kFail);
}

TEST(JudgedAgain, RunWithAFaultyOutletHasTheSameVerdicts) {
  FakeStation station(with(&Script::answers_settings, false));
  EXPECT_EQ(verdict_when_judged_again(test::plan(0.5), station), record::Verdict::kError);
}

TEST(JudgedAgain, RunEndedByABenchFaultHasTheSameVerdicts) {
  FakeStation station(with(&Script::play_fails_at, 2));
  EXPECT_EQ(verdict_when_judged_again(test::plan(0.5), station), record::Verdict::kError);
}

TEST(JudgedAgain, InterruptedRunHasTheSameVerdicts) {
  const std::atomic<bool> stop{true};
  FakeStation station({});
  EXPECT_EQ(verdict_when_judged_again(test::plan(0.5), station, &stop), record::Verdict::kError);
}

}  // namespace
}  // namespace gsbench::station::test
