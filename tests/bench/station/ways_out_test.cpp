// Every way out of a run leaves the station safe and the record with a reason.

#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/temporary_folder.hpp>

#include <atomic>
#include <utility>

#include <gmock/gmock.h>

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

// Of a run that has an end of its own, safe by then.
record::RunRecord play(FakeStation& station, const RunOptions& options = {},
                       const profile::Plan& plan = one_second()) {
  record::RunRecord record = run(plan, station, options);
  EXPECT_TRUE(station.is_safe());
  return record;
}

void expect_error(const Script& script, const std::string& reason) {
  FakeStation station(script);
  const record::RunRecord record = play(station);
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
  const record::RunRecord record = play(station, {}, plan(duration_s, kCommand));
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
  const record::RunRecord record = play(station);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_EQ(station.blocks_played(), kBlocks);
  EXPECT_EQ(station.tick(), 8000);
}

TEST(WaysOut, ASourceThatDoesNotStart) {
  expect_error(with(&Script::start_error, "fake source: no such port"),
               "fake source: no such port");
}

TEST(WaysOut, ASourceThatCannotBeSwitchedOff) {
  Script script = with(&Script::make_safe_error, "fake source: relay welded");
  expect_error(script, "the source may still be live: fake source: relay welded");
  script.play_fails_at = 3;
  expect_error(script, "fake source: tripped; the source may still be live");
}

TEST(WaysOut, ALinkThatDoesNotOpen) {
  expect_error(with(&Script::open_error, "fake link: no broker"), "fake link: no broker");
}

// Settings to two outlets, the command to two.
TEST(WaysOut, ALinkThatCannotSendAnyOneMessage) {
  for (int message = 0; message < 4; ++message) {
    expect_error(with(&Script::send_fails_at, message), "fake link: cannot send");
  }
}

TEST(WaysOut, ADriverThatFailsAtAnyBlock) {
  for (int block = 0; block < kBlocks; ++block) {
    expect_error(with(&Script::play_fails_at, block), "fake source: tripped");
    expect_error(with(&Script::link_poll_fails_at, block), "fake link: broken");
    expect_error(with(&Script::relay_poll_fails_at, block), "fake relay sense: unplugged");
  }
}

TEST(WaysOut, TooFewOutlets) {
  expect_error(with(&Script::outlets, 1U), "needs 2 outlets; the station has 1");
}

TEST(WaysOut, AnOutletOfAnotherProtocol) {
  expect_fault_of_the_last(with(&Script::protocol_version, std::uint16_t{7}),
                           "speaks protocol 7, not 2");
}

TEST(WaysOut, AnOutletThatRefusesItsSettings) {
  constexpr auto kError = gs::outlet::SettingsError::kThreshold;
  expect_fault_of_the_last(with(&Script::settings_error, kError),
                           std::string("refused its settings: ") + to_string(kError));
}

TEST(WaysOut, AnOutletThatDoesNotAnswerToItsSettings) {
  const Script script = with(&Script::answers_settings, false);
  expect_fault_of_the_last(script, "did not answer to its settings");
  // In a run that ends before the answer is due, too.
  expect_fault_of_the_last(script, "did not answer to its settings", 0.56);
}

TEST(WaysOut, AnOutletThatFallsSilent) {
  expect_fault_of_the_last(with(&Script::silent_from_tick, 8000),
                           "fell silent after its sample 7936", 3.0);
}

TEST(WaysOut, AnOutletThatIsSilentForASecondIsStillThere) {
  // The last report is at tick 7936: a second later is 15936 of 15920.
  FakeStation station(with(&Script::silent_from_tick, 8000));
  EXPECT_EQ(play(station, {}, plan(1.99)).verdict, Verdict::kPass);
}

TEST(WaysOut, TheOnlyOutletLostEndsTheRunEarly) {
  Script script = with(&Script::silent_from_tick, 8000);
  script.outlets = 1;
  FakeStation station(script);
  const record::RunRecord record = play(station, {}, plan(30.0, "", "[[outlet]]\n"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("fell silent after its sample 7936"));
  EXPECT_LT(station.tick(), 3 * 8000);
}

TEST(WaysOut, AFaultKeepsWhatWasCapturedUntilThen) {
  FakeStation station(with(&Script::play_fails_at, 5));
  const record::RunRecord record = play(station);
  ASSERT_EQ(record.outlets.size(), 2U);
  // Until 0.496 s, every 16 ms.
  EXPECT_EQ(record.outlets[0].trace.tick.size(), 31U);
  EXPECT_TRUE(record.outlets[0].measurements.empty()) << "half a run is not judged";
}

// Stopped once so much of it is played; below 0 before it begins.
record::RunRecord stopped_at(double stop_at, FakeStation& station) {
  std::atomic<bool> stop{stop_at < 0.0};
  RunOptions options;
  options.stop = &stop;
  options.progress = [&](double part) { stop = part >= stop_at; };
  record::RunRecord record = play(station, options);
  EXPECT_TRUE(stop) << "it never came so far";
  return record;
}

TEST(WaysOut, AStopEndsAfterTheBlockInHand) {
  for (const auto& [stop_at, blocks] : {std::pair(-1.0, 0), std::pair(0.45, 5)}) {
    FakeStation station({});
    const record::RunRecord record = stopped_at(stop_at, station);
    EXPECT_EQ(station.blocks_played(), blocks);
    EXPECT_EQ(record.verdict, Verdict::kError);
    EXPECT_THAT(record.verdict_reason, HasSubstr("interrupted"));
    EXPECT_TRUE(record.interrupted);
    for (const record::OutletRecord& outlet : record.outlets) {
      EXPECT_EQ(outlet.verdict, Verdict::kError);
    }
  }
}

TEST(WaysOut, AStopAfterTheLastBlockChangesNothing) {
  FakeStation station({});
  const record::RunRecord record = stopped_at(1.0, station);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_FALSE(record.interrupted);
}

TEST(WaysOut, ADriverThatThrowsAgainstItsRules) {
  for (int block = 0; block < kBlocks; ++block) {
    FakeStation station(with(&Script::play_throws_at, block));
    EXPECT_THROW(run(one_second(), station, {}), std::runtime_error);
    EXPECT_TRUE(station.is_safe());
  }
}

TEST(WaysOut, AProgressThatThrows) {
  FakeStation station({});
  RunOptions options;
  options.progress = [](double) { throw std::runtime_error("no terminal"); };
  EXPECT_THROW(run(one_second(), station, options), std::runtime_error);
  EXPECT_TRUE(station.is_safe());
}

class WrittenWaysOut : public testing::Test {
 protected:
  WrittenWaysOut() { options_.writer = &writer_; }

  const gsbench::test::TemporaryFolder folder_;
  record::Writer writer_{folder_.file("run.gsbench")};
  FakeStation station_{{}};
  RunOptions options_;
};

TEST_F(WrittenWaysOut, ARecordThatCannotBeBegun) {
  writer_.begin({});  // a second time is refused
  EXPECT_ANY_THROW(run(one_second(), station_, options_));
  EXPECT_TRUE(station_.is_safe());
  EXPECT_EQ(station_.blocks_played(), 0);
}

TEST_F(WrittenWaysOut, ARecordThatCannotBeWrittenAtTheEnd) {
  bool finished = false;
  options_.progress = [&](double) {
    if (!finished) {
      writer_.finish({});  // outlets after it are refused
    }
    finished = true;
  };
  EXPECT_ANY_THROW(run(one_second(), station_, options_));
  EXPECT_TRUE(station_.is_safe());
  EXPECT_EQ(station_.blocks_played(), kBlocks);
}

TEST_F(WrittenWaysOut, SettingsThatTheFirmwareRefusesEndTheRunBeforeAnythingIsTouched) {
  profile::Plan refused = one_second();
  refused.outlets[1].settings.settings["threshold_mw"] = -1.0;
  EXPECT_THROW(run(refused, station_, options_), profile::ConfigurationError);
  EXPECT_FALSE(station_.was_touched());
  EXPECT_NO_THROW(writer_.begin({})) << "nothing was written";
}

}  // namespace
}  // namespace gsbench::station::test
