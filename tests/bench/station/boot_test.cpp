// From energising to the start: the voltage is held, the wait is shown, and outlets that do not
// join are faulty.
#include "fake_station.hpp"
#include "plans.hpp"

#include <atomic>

#include <gmock/gmock.h>

#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

using record::Verdict;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr std::chrono::milliseconds kBoot{120};

Script booting() {
  return with(&Script::answers_within, kBoot);
}

struct Waited {
  record::RunRecord record;
  std::vector<std::string> shown;
};

Waited run_on(FakeStation& station) {
  Waited waited;
  RunOptions options;
  options.waiting = [&](const std::string& what) { waited.shown.push_back(what); };
  waited.record = run(plan(0.5), station, options);
  EXPECT_TRUE(station.is_safe());
  return waited;
}

TEST(Boot, OpensTheLinkBeforeItEnergises) {
  FakeStation station(booting());
  EXPECT_EQ(run_on(station).record.verdict, Verdict::kPass);
  EXPECT_TRUE(station.was_open_when_energised()) << "a broker may take seconds to answer";
}

TEST(Boot, HoldsTheVoltageAndShowsTheWait) {
  Script script = booting();
  script.joins = false;
  FakeStation station(script);
  const Waited waited = run_on(station);
  // A hold about every 2 ms; every 50 ms at least.
  EXPECT_GE(station.holds(), 4);
  EXPECT_THAT(waited.shown, Contains("waiting for outlets: 1 of 2 joined, 1 s left"));
}

TEST(Boot, OutletThatDoesNotJoinIsFaultyAndTheOthersRun) {
  Script script = booting();
  script.joins = false;
  FakeStation station(script);
  const record::RunRecord record = run_on(station).record;
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_EQ(record.outlets[0].verdict, Verdict::kPass) << record.outlets[0].fault;
  EXPECT_EQ(record.outlets[1].verdict, Verdict::kError);
  EXPECT_EQ(record.outlets[1].fault, "does not answer (waited 0.12 s for it)");
}

// The wait ends as soon as all have joined, except for what cannot say that it has booted.
TEST(Boot, OnlyALoadedSourceOrADeviceWithoutALinkNeedsAllOfIt) {
  Script script;
  script.answers_within = std::chrono::hours(1);
  FakeStation streamed(script);
  EXPECT_EQ(run_on(streamed).record.verdict, Verdict::kPass);

  script = booting();
  script.kind = source::Kind::kLoaded;
  FakeStation loaded(script);
  EXPECT_THAT(run_on(loaded).shown, Contains(HasSubstr("nominal voltage for outlets to boot")));
  EXPECT_GE(loaded.holds(), 3);
}

TEST(Boot, SourceThatIsSwitchedOffDuringItEndsTheRun) {
  Script script = booting();
  script.joins = false;
  script.hold_fails_at = 3;
  FakeStation station(script);
  const record::RunRecord record = run_on(station).record;
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("someone switched it off"));
  EXPECT_EQ(station.holds(), 4);
}

TEST(Boot, StopEndsItAtOnce) {
  for (const bool joins : {false, true}) {
    Script script = with(&Script::answers_within, std::chrono::milliseconds(std::chrono::hours(1)));
    script.joins = joins;
    script.kind = source::Kind::kLoaded;
    FakeStation station(script);
    std::atomic<bool> stop{false};
    int shown = 0;
    RunOptions options;
    options.stop = &stop;
    options.waiting = [&](const std::string& what) {
      // With all outlets, stop in the rest of the wait.
      stop = ++shown > 3 && (!joins || what.find("boot") != std::string::npos);
    };
    const record::RunRecord record = run(plan(0.5), station, options);
    EXPECT_TRUE(station.is_safe());
    EXPECT_TRUE(record.interrupted);
    EXPECT_EQ(record.verdict, Verdict::kError);
    EXPECT_EQ(record.fault, "");
    EXPECT_EQ(station.blocks_played(), 0);
  }
}

}  // namespace
}  // namespace gsbench::station::test
