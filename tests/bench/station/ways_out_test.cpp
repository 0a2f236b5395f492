// Every way out of a run leaves the station safe and the record with a reason.

#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/temporary_folder.hpp>


#include <gmock/gmock.h>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

using record::Verdict;
using ::testing::HasSubstr;

const char* const kCommand = "[[command]]\nat_s = 0.55\nswitch = \"off\"\n";

// Blocks end at 0.096 s, where the answers are due, then every 0.1 s, and at the command: 0.096,
// 0.196 … 0.496, 0.55, 0.65 … 0.95, 1.
constexpr int kBlocks = 11;

profile::Plan one_second() {
  return plan(1.0, kCommand);
}

void expect_safe(const FakeStation& station) {
  EXPECT_TRUE(station.is_safe());
}

void expect_error(const Script& script, const std::string& reason, double duration_s = 1.0) {
  FakeStation station(script);
  const record::RunRecord record = run(plan(duration_s, kCommand), station, {});
  expect_safe(station);
  EXPECT_EQ(record.verdict, Verdict::kError) << reason;
  EXPECT_THAT(record.fault, HasSubstr(reason));
  EXPECT_EQ(record.verdict_reason, record.fault);
  for (const record::OutletRecord& outlet : record.outlets) {
    EXPECT_EQ(outlet.verdict, Verdict::kError) << reason;
  }
}

// One outlet is lost, the other goes on to the end.
void expect_fault_of_the_last(const Script& script, const std::string& reason,
                              double duration_s = 1.0) {
  FakeStation station(script);
  const record::RunRecord record = run(plan(duration_s, kCommand), station, {});
  expect_safe(station);
  EXPECT_EQ(record.verdict, Verdict::kError) << reason;
  EXPECT_THAT(record.verdict_reason, HasSubstr("serial-2 " + reason));
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_EQ(record.outlets[0].verdict, Verdict::kPass) << record.outlets[0].fault;
  EXPECT_EQ(record.outlets[1].verdict, Verdict::kError);
  EXPECT_THAT(record.outlets[1].fault, HasSubstr(reason));
  const auto reports = static_cast<std::size_t>(duration_s / 0.016);
  EXPECT_EQ(record.outlets[0].trace.tick.size(), reports);
}

TEST(WaysOut, TheNormalEndIsSafeAndNoError) {
  FakeStation station({});
  const record::RunRecord record = run(one_second(), station, {});
  expect_safe(station);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_EQ(station.blocks_played(), kBlocks);
  EXPECT_EQ(station.tick(), 8000);
}

TEST(WaysOut, ASourceThatDoesNotStart) {
  Script script;
  script.start_error = "fake source: no such port";
  expect_error(script, "fake source: no such port");
}

TEST(WaysOut, ASourceThatCannotBeSwitchedOff) {
  Script script;
  script.make_safe_error = "fake source: relay welded";
  expect_error(script, "the source may still be live: fake source: relay welded");
  script.play_fails_at = 3;
  expect_error(script, "fake source: tripped; the source may still be live");
}

TEST(WaysOut, ASourceThatFailsAtAnyBlock) {
  for (int block = 0; block < kBlocks; ++block) {
    Script script;
    script.play_fails_at = block;
    expect_error(script, "fake source: tripped");
  }
}

TEST(WaysOut, ALinkThatDoesNotOpen) {
  Script script;
  script.open_error = "fake link: no broker";
  expect_error(script, "fake link: no broker");
}

// Settings to two outlets, the command to two.
TEST(WaysOut, ALinkThatCannotSendAnyOneMessage) {
  for (int message = 0; message < 4; ++message) {
    Script script;
    script.send_fails_at = message;
    expect_error(script, "fake link: cannot send");
  }
}

TEST(WaysOut, ALinkThatBreaksAtAnyBlock) {
  for (int block = 0; block < kBlocks; ++block) {
    Script script;
    script.link_poll_fails_at = block;
    expect_error(script, "fake link: broken");
  }
}

TEST(WaysOut, ARelaySenseThatBreaksAtAnyBlock) {
  for (int block = 0; block < kBlocks; ++block) {
    Script script;
    script.relay_poll_fails_at = block;
    expect_error(script, "fake relay sense: unplugged");
  }
}

TEST(WaysOut, TooFewOutlets) {
  Script script;
  script.outlets = 1;
  expect_error(script, "needs 2 outlets; the station has 1");
}

TEST(WaysOut, AnOutletOfAnotherProtocol) {
  Script script;
  script.protocol_version = 7;
  expect_fault_of_the_last(script, "speaks protocol 7, not 2");
}

TEST(WaysOut, AnOutletThatRefusesItsSettings) {
  Script script;
  script.settings_error = gs::outlet::SettingsError::kThreshold;
  expect_fault_of_the_last(script, std::string("refused its settings: ") +
                                       to_string(gs::outlet::SettingsError::kThreshold));
}

TEST(WaysOut, AnOutletThatDoesNotAnswerToItsSettings) {
  Script script;
  script.answers_settings = false;
  expect_fault_of_the_last(script, "did not answer to its settings");
  // In a run that ends before the answer is due, too.
  expect_fault_of_the_last(script, "did not answer to its settings", 0.56);
}

TEST(WaysOut, AnOutletThatFallsSilent) {
  Script script;
  script.silent_from_tick = 8000;
  expect_fault_of_the_last(script, "fell silent after its sample 7936", 3.0);
}

TEST(WaysOut, AnOutletThatIsSilentForASecondIsStillThere) {
  Script script;
  // The last report is at tick 7936: a second later is 15936 of 15920.
  script.silent_from_tick = 8000;
  FakeStation station(script);
  EXPECT_EQ(run(plan(1.99), station, {}).verdict, Verdict::kPass);
}

TEST(WaysOut, TheOnlyOutletLostEndsTheRunEarly) {
  Script script;
  script.outlets = 1;
  script.silent_from_tick = 8000;
  FakeStation station(script);
  profile::Plan alone = plan(30.0);
  alone.outlets.resize(1);
  const record::RunRecord record = run(alone, station, {});
  expect_safe(station);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("fell silent after its sample 7936"));
  EXPECT_LT(station.tick(), 3 * 8000);
}

TEST(WaysOut, AFaultKeepsWhatWasCapturedUntilThen) {
  Script script;
  script.play_fails_at = 5;
  FakeStation station(script);
  const record::RunRecord record = run(one_second(), station, {});
  ASSERT_EQ(record.outlets.size(), 2U);
  // Until 0.496 s, every 16 ms.
  EXPECT_EQ(record.outlets[0].trace.tick.size(), 31U);
  EXPECT_TRUE(record.outlets[0].measurements.empty()) << "half a run is not judged";
}

TEST(WaysOut, AStopBeforeTheFirstBlock) {
  const std::atomic<bool> stop{true};
  FakeStation station({});
  RunOptions options;
  options.stop = &stop;
  const record::RunRecord record = run(one_second(), station, options);
  expect_safe(station);
  EXPECT_EQ(station.blocks_played(), 0);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("interrupted"));
  EXPECT_TRUE(record.interrupted);
}

TEST(WaysOut, AStopAfterTheLastBlockChangesNothing) {
  std::atomic<bool> stop{false};
  FakeStation station({});
  RunOptions options;
  options.stop = &stop;
  options.progress = [&](double part) { stop = part >= 1.0; };
  const record::RunRecord record = run(one_second(), station, options);
  EXPECT_TRUE(stop);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_FALSE(record.interrupted);
}

TEST(WaysOut, AStopInTheMiddleEndsAfterTheBlockInHand) {
  std::atomic<bool> stop{false};
  FakeStation station({});
  RunOptions options;
  options.stop = &stop;
  options.progress = [&](double part) { stop = part > 0.45; };
  const record::RunRecord record = run(one_second(), station, options);
  expect_safe(station);
  EXPECT_EQ(station.blocks_played(), 5);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("interrupted"));
  for (const record::OutletRecord& outlet : record.outlets) {
    EXPECT_EQ(outlet.verdict, Verdict::kError);
  }
}

TEST(WaysOut, ADriverThatThrowsAgainstItsRules) {
  for (int block = 0; block < kBlocks; ++block) {
    Script script;
    script.play_throws_at = block;
    FakeStation station(script);
    EXPECT_THROW(run(one_second(), station, {}), std::runtime_error);
    expect_safe(station);
  }
}

TEST(WaysOut, AProgressThatThrows) {
  FakeStation station({});
  RunOptions options;
  options.progress = [](double) { throw std::runtime_error("no terminal"); };
  EXPECT_THROW(run(one_second(), station, options), std::runtime_error);
  expect_safe(station);
}

TEST(WaysOut, ARecordThatCannotBeBegun) {
  gsbench::test::TemporaryFolder folder;
  record::Writer writer(folder.file("run.gsbench"));
  writer.begin({});  // a second time is refused
  FakeStation station({});
  RunOptions options;
  options.writer = &writer;
  EXPECT_ANY_THROW(run(one_second(), station, options));
  expect_safe(station);
  EXPECT_EQ(station.blocks_played(), 0);
}

TEST(WaysOut, ARecordThatCannotBeWrittenAtTheEnd) {
  gsbench::test::TemporaryFolder folder;
  record::Writer writer(folder.file("run.gsbench"));
  FakeStation station({});
  RunOptions options;
  options.writer = &writer;
  bool finished = false;
  options.progress = [&](double) {
    if (!finished) writer.finish({});  // outlets after it are refused
    finished = true;
  };
  EXPECT_ANY_THROW(run(one_second(), station, options));
  expect_safe(station);
  EXPECT_EQ(station.blocks_played(), kBlocks);
}

TEST(WaysOut, SettingsThatTheFirmwareRefusesEndTheRunBeforeAnythingIsTouched) {
  gsbench::test::TemporaryFolder folder;
  record::Writer writer(folder.file("run.gsbench"));
  profile::Plan refused = one_second();
  refused.outlets[1].settings.settings["threshold_mw"] = -1.0;
  FakeStation station({});
  RunOptions options;
  options.writer = &writer;
  EXPECT_THROW(run(refused, station, options), profile::ConfigurationError);
  EXPECT_FALSE(station.was_touched());
  EXPECT_NO_THROW(writer.begin({})) << "nothing was written";
}

TEST(WaysOut, AFaultIsInTheRecordOnTheDiskToo) {
  gsbench::test::TemporaryFolder folder;
  const std::string path = folder.file("run.gsbench");
  Script script;
  script.link_poll_fails_at = 3;
  FakeStation station(script);
  record::RunRecord returned;
  {
    record::Writer writer(path);
    RunOptions options;
    options.writer = &writer;
    returned = run(one_second(), station, options);
  }
  const record::RunRecord kept = record::read_run(path);
  EXPECT_EQ(kept.verdict, Verdict::kError);
  EXPECT_EQ(kept.verdict_reason, "fake link: broken");
  EXPECT_EQ(record::content_digest(kept), record::content_digest(returned));
}

}  // namespace
}  // namespace gsbench::station::test
