// The same plan and seed give the same record for any block size, number of threads and pace.

#include "plans.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <record/store.hpp>
#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

// A loss with a decision, commands and settings that fall on no block boundary, a dip and a phase
// step.
profile::Plan eventful() {
  return plan(4.5,
              "noise_pct = 1.0\n"
              "[[signal.amplitude_step]]\nat_s = 0.7\nduration_s = 0.2\nlevel_pct = 40.0\n"
              "[[signal.phase_jump]]\nat_s = 4.1\ndegrees = 20.0\n"
              "[[grid.loss]]\nat_s = 2.0\npower_mw = 500.0\n"
              "[[settings]]\nat_s = 1.7171\nthreshold_mw = 340.0\n"
              "[[command]]\nat_s = 1.2345\nswitch = \"off\"\n"
              "[[command]]\nat_s = 1.5\nswitch = \"on\"\n",
              "[[outlet]]\ncount = 3\naccumulated_mw = 100.0\n");
}

record::RunRecord simulated_record(const profile::Plan& plan, std::size_t threads, double block_s,
                                   bool real_time = false) {
  SimulatedOptions options;
  options.threads = threads;
  options.block_s = block_s;
  options.real_time = real_time;
  const auto station = simulated_station(plan, options);
  return run(plan, *station, {});
}

std::string digest(const profile::Plan& plan, std::size_t threads, double block_s) {
  return record::content_digest(simulated_record(plan, threads, block_s));
}

TEST(Determinism, RecordContainsEverythingThatCouldDiffer) {
  const record::RunRecord record = simulated_record(eventful(), 1, 0.512);
  EXPECT_NE(record.verdict, record::Verdict::kError) << record.verdict_reason;
  for (const record::OutletRecord& outlet : record.outlets) {
    EXPECT_EQ(outlet.fault, "") << "the firmware acknowledges settings that are sent again";
    EXPECT_EQ(std::count_if(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                            [](const record::Mark& mark) { return mark.kind == "settings"; }),
              1);
    // Opened and closed by command, opened by the decision.
    int openings = 0;
    for (const record::Mark& mark : outlet.reports.marks) {
      openings += mark.kind == "relay.sense" && mark.value < 0.5 ? 1 : 0;
    }
    EXPECT_GE(openings, 2) << outlet.id;
    EXPECT_FALSE(outlet.reports.estimates.tick.empty()) << outlet.id;
  }
}

TEST(Determinism, RecordDoesNotDependOnBlocksOrThreads) {
  const profile::Plan plan = eventful();
  const std::string expected = digest(plan, 1, 0.512);
  for (const double block_s : {0.016, 0.1, 0.512, 3.0}) {
    for (const std::size_t threads : {1U, 2U, 3U}) {
      EXPECT_EQ(digest(plan, threads, block_s), expected) << block_s << " s, " << threads;
    }
  }
}

TEST(Determinism, BlockMayBeShorterThanASampleOrLongerThanTheRun) {
  const profile::Plan plan = test::plan(0.2, "noise_pct = 1.0\n");
  EXPECT_EQ(digest(plan, 1, 1e-9), digest(plan, 1, 1e6));
}

TEST(Determinism, AnotherSeedGivesAnotherRecord) {
  profile::Plan plan = eventful();
  const record::RunRecord one = simulated_record(plan, 1, 0.512);
  plan.seed = 2;
  const record::RunRecord other = simulated_record(plan, 1, 0.512);
  EXPECT_NE(record::content_digest(one), record::content_digest(other));
  EXPECT_NE(one.outlets[0].reports.trace.frequency_hz, other.outlets[0].reports.trace.frequency_hz)
      << "the noise must differ, not only the seed";
}

TEST(Determinism, TwoRunsDifferInTheirIdOnly) {
  const profile::Plan plan = test::plan(0.2, "noise_pct = 1.0\n");
  const record::RunRecord one = simulated_record(plan, 1, 0.512);
  const record::RunRecord other = simulated_record(plan, 1, 0.512);
  EXPECT_NE(one.run_id, other.run_id);
  EXPECT_EQ(record::content_digest(one), record::content_digest(other));
}

TEST(Determinism, RealTimeGivesTheSameRecordAsVirtualTime) {
  const profile::Plan plan = test::plan(0.3, "noise_pct = 1.0\n");
  EXPECT_EQ(record::content_digest(simulated_record(plan, 2, 0.0, true)), digest(plan, 1, 0.0));
}

// A station can be used for several runs.
TEST(Determinism, SecondRunOnTheSameStationGivesTheSameRecord) {
  const profile::Plan plan = eventful();
  const auto station = simulated_station(plan, {});
  const std::string first = record::content_digest(run(plan, *station, {}));
  EXPECT_EQ(record::content_digest(run(plan, *station, {})), first);
}

}  // namespace
}  // namespace gsbench::station::test
