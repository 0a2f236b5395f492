// Every end of a run leaves the station in its safe state and a reason in the record.

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

// Blocks end at 0.096 s, when the answers are due, then every 0.1 s, and at the command: 0.096,
// 0.196 … 0.496, 0.55, 0.65 … 0.95, 1 s.
constexpr int kBlocks = 11;

profile::Plan one_second() {
  return plan(1.0, kCommand);
}

// Runs the plan and expects the safe state afterwards.
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

// The last outlet is faulty; the other one runs to the end.
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
  EXPECT_EQ(record.outlets[0].reports.trace.tick.size(), reports);
}

TEST(RunEnd, NormalEndIsSafeAndWithoutError) {
  FakeStation station({});
  const record::RunRecord record = play(station);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_EQ(station.blocks_played(), kBlocks);
  EXPECT_EQ(station.tick(), 8000);
}

TEST(RunEnd, SourceThatDoesNotStartIsError) {
  expect_error(with(&Script::start_error, "fake source: no such port"),
               "fake source: no such port");
}

TEST(RunEnd, SourceThatCannotBeSwitchedOffIsError) {
  Script script = with(&Script::make_safe_error, "fake source: relay welded");
  expect_error(script, "output state unknown: fake source: relay welded");
  script.play_fails_at = 3;
  expect_error(script, "fake source: tripped; output state unknown");
}

TEST(RunEnd, LinkThatDoesNotOpenIsError) {
  expect_error(with(&Script::open_error, "fake link: no broker"), "fake link: no broker");
}

TEST(RunEnd, OutletThatCannotBeReachedIsFaulty) {
  expect_fault_of_the_last(with(&Script::unreachable, std::size_t{1}),
                           "cannot be reached: fake port: refused");
}

TEST(RunEnd, NoOutletThatCanBeReachedIsErrorBeforeTheSourceIsEnergised) {
  Script script = with(&Script::unreachable, std::size_t{2});
  FakeStation station(script);
  const record::RunRecord record = play(station);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_EQ(record.fault,
            "outlet on serial-1 cannot be reached: fake port: refused; no outlet is left");
  EXPECT_FALSE(station.was_energised());
  script.without_link = true;
  FakeStation with_contact(script);
  (void)play(with_contact, {},
             parse("title = \"A test\"\nsource = \"None\"\n[grid]\n"
                   "system = \"ieee24\"\n[signal]\nduration_s = 1.0\n"
                   "[[outlet]]\ncount = 2\n[[expect]]\n"
                   "measure = \"relay.end\"\nequals = \"open\"\n"));
  EXPECT_TRUE(with_contact.was_energised());
}

// Without its relay sense a run could not judge the contacts, so no outlet gets voltage for it.
TEST(RunEnd, RelaySenseThatDoesNotOpenIsErrorBeforeTheSourceIsEnergised) {
  FakeStation station(with(&Script::sense_open_error, "/dev/ttyUSB1: No such file or directory"));
  const record::RunRecord record = play(station);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_EQ(record.fault, "/dev/ttyUSB1: No such file or directory");
  EXPECT_EQ(record.verdict_reason, record.fault);
  EXPECT_FALSE(station.was_energised());
  EXPECT_EQ(station.blocks_played(), 0);
}

// Settings and a self test to each of two outlets.
TEST(RunEnd, LinkThatCannotSendAMessageIsError) {
  for (int message = 0; message < 4; ++message) {
    expect_error(with(&Script::send_fails_at, message), "fake link: cannot send");
  }
}

TEST(RunEnd, DriverFailureInAnyBlockIsError) {
  for (int block = 0; block < kBlocks; ++block) {
    expect_error(with(&Script::play_fails_at, block), "fake source: tripped");
    expect_error(with(&Script::link_poll_fails_at, block), "fake link: broken");
    expect_error(with(&Script::relay_poll_fails_at, block), "fake relay sense: unplugged");
  }
}

TEST(RunEnd, TooFewOutletsAreAnError) {
  expect_error(with(&Script::outlets, 1U), "needs 2 outlets; the station has 1");
}

TEST(RunEnd, OutletWithAnotherProtocolIsExcluded) {
  expect_fault_of_the_last(with(&Script::protocol_version, std::uint16_t{7}),
                           "uses protocol version 7, not 3");
}

TEST(RunEnd, OutletThatRefusesItsSettingsIsFaulty) {
  constexpr auto kError = gs::outlet::SettingsError::kThreshold;
  expect_fault_of_the_last(with(&Script::settings_error, kError),
                           std::string("refused its settings: ") + to_string(kError));
}

TEST(RunEnd, OutletThatDoesNotAcknowledgeItsSettingsIsFaulty) {
  const Script script = with(&Script::answers_settings, false);
  expect_fault_of_the_last(script, "did not acknowledge its settings");
  // Also in a run that ends soon after the answer is due.
  expect_fault_of_the_last(script, "did not acknowledge its settings", 0.56);
}

constexpr const char* kSettingsAgain = "[[settings]]\nat_s = 0.3\n[[settings]]\nat_s = 0.6\n";

void expect_fault_after_settings_again(const Script& script, const std::string& fault,
                                       double duration_s) {
  FakeStation station(script);
  const record::RunRecord record = play(station, {}, plan(duration_s, kSettingsAgain));
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_EQ(record.outlets[0].fault, "");
  EXPECT_EQ(record.outlets[1].fault, fault);
}

TEST(RunEnd, OutletThatRefusesSettingsSentAgainIsFaulty) {
  constexpr auto kError = gs::outlet::SettingsError::kThreshold;
  expect_fault_after_settings_again(
      with(&Script::later_settings_error, kError),
      std::string("refused its settings of 0.3 s: ") + to_string(kError), 3.0);
}

TEST(RunEnd, OutletThatDoesNotAcknowledgeSettingsSentAgainIsFaulty) {
  const Script script = with(&Script::answers_later_settings, false);
  const std::string fault = "did not acknowledge its settings of 0.3 s";
  expect_fault_after_settings_again(script, fault, 3.0);
  // Also in a run that ends before a second has passed.
  expect_fault_after_settings_again(script, fault, 0.75);
}

TEST(RunEnd, OutletThatAcknowledgesAllSettingsIsNotFaulty) {
  expect_fault_after_settings_again({}, "", 3.0);
  expect_fault_after_settings_again({}, "", 0.75);
}

TEST(RunEnd, OutletThatStopsReportingIsFaulty) {
  expect_fault_of_the_last(with(&Script::silent_from_tick, 8000),
                           "stopped reporting after its sample 7936", 3.0);
}

TEST(RunEnd, OutletMayBeSilentForOneSecond) {
  // The last report is at tick 7936. One second later is tick 15936, after the end at 15920.
  FakeStation station(with(&Script::silent_from_tick, 8000));
  EXPECT_EQ(play(station, {}, plan(1.99)).verdict, Verdict::kPass);
}

TEST(RunEnd, LossOfTheOnlyOutletEndsTheRun) {
  Script script = with(&Script::silent_from_tick, 8000);
  script.outlets = 1;
  FakeStation station(script);
  const record::RunRecord record = play(station, {}, plan(30.0, "", "[[outlet]]\n"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("stopped reporting after its sample 7936"));
  EXPECT_LT(station.tick(), 3 * 8000);
}

TEST(RunEnd, FaultKeepsTheReportsCapturedSoFar) {
  FakeStation station(with(&Script::play_fails_at, 5));
  const record::RunRecord record = play(station);
  ASSERT_EQ(record.outlets.size(), 2U);
  // Until 0.496 s, every 16 ms.
  EXPECT_EQ(record.outlets[0].reports.trace.tick.size(), 31U);
  EXPECT_TRUE(record.outlets[0].measurements.empty()) << "an incomplete run is not judged";
}

// Stops a run when this part of it, 0 … 1, has been played; negative: before its start.
record::RunRecord stopped_at(double stop_at, FakeStation& station) {
  std::atomic<bool> stop{stop_at < 0.0};
  RunOptions options;
  options.stop = &stop;
  options.progress = [&](double part) { stop = part >= stop_at; };
  record::RunRecord record = play(station, options);
  EXPECT_TRUE(stop) << "the run ended before stop_at";
  return record;
}

TEST(RunEnd, StopTakesEffectAfterTheCurrentBlock) {
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

TEST(RunEnd, StopWithinACallOfTheSourceIsNoFault) {
  for (const char* const call : {"upload", "power_up", "keep_up", "begin", "play_until", "end"}) {
    std::atomic<bool> stop{false};
    Script script;
    script.stops_in = call;
    script.stop = &stop;
    FakeStation station(script);
    RunOptions options;
    options.stop = &stop;
    const record::RunRecord record = play(station, options);
    EXPECT_TRUE(stop) << call;
    EXPECT_TRUE(record.interrupted) << call;
    EXPECT_EQ(record.fault, "") << call;
    EXPECT_EQ(record.verdict, Verdict::kError) << call;
    EXPECT_EQ(station.blocks_played(), std::string(call) == "end" ? kBlocks : 0) << call;
  }
}

TEST(RunEnd, FaultDuringAStopIsAFault) {
  std::atomic<bool> stop{false};
  Script script = with(&Script::start_error, "fake source: no such port");
  script.stops_in = "upload";
  script.stop = &stop;
  FakeStation station(script);
  // The run has no flag, so the source does not heed it.
  const record::RunRecord record = play(station);
  EXPECT_TRUE(stop);
  EXPECT_FALSE(record.interrupted);
  EXPECT_EQ(record.fault, "fake source: no such port");
}

TEST(RunEnd, StopAfterTheLastBlockChangesNothing) {
  FakeStation station({});
  const record::RunRecord record = stopped_at(1.0, station);
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  EXPECT_FALSE(record.interrupted);
}

TEST(RunEnd, DriverThatThrowsLeavesTheStationSafe) {
  for (int block = 0; block < kBlocks; ++block) {
    FakeStation station(with(&Script::play_throws_at, block));
    EXPECT_THROW(run(one_second(), station, {}), std::runtime_error);
    EXPECT_TRUE(station.is_safe());
  }
}

TEST(RunEnd, ProgressCallbackThatThrowsLeavesTheStationSafe) {
  FakeStation station({});
  RunOptions options;
  options.progress = [](double) { throw std::runtime_error("no terminal"); };
  EXPECT_THROW(run(one_second(), station, options), std::runtime_error);
  EXPECT_TRUE(station.is_safe());
}

class RecordedRunEnd : public testing::Test {
 protected:
  RecordedRunEnd() { options_.writer = &writer_; }

  const gsbench::test::TemporaryFolder folder_;
  record::Writer writer_{folder_.file("run.gsbench")};
  FakeStation station_{{}};
  RunOptions options_;
};

TEST_F(RecordedRunEnd, RecordThatCannotBeCreatedThrows) {
  writer_.begin({});  // a second begin() is refused
  EXPECT_ANY_THROW(run(one_second(), station_, options_));
  EXPECT_TRUE(station_.is_safe());
  EXPECT_EQ(station_.blocks_played(), 0);
}

TEST_F(RecordedRunEnd, RecordThatCannotBeWrittenAtTheEndThrows) {
  options_.progress = [&](double part) {
    if (part == 1.0) {
      writer_.finish({});  // results after finish() are refused
    }
  };
  EXPECT_ANY_THROW(run(one_second(), station_, options_));
  EXPECT_TRUE(station_.is_safe());
  EXPECT_EQ(station_.blocks_played(), kBlocks);
}

TEST_F(RecordedRunEnd, RecordThatCannotBeWrittenDoesNotHideThatTheStateIsUnknown) {
  FakeStation welded(with(&Script::make_safe_error, "fake source: relay welded"));
  std::string unknown;
  options_.output_unknown = [&](const std::string& what) { unknown = what; };
  options_.progress = [&](double part) {
    if (part == 1.0) {
      writer_.finish({});
    }
  };
  EXPECT_ANY_THROW(run(one_second(), welded, options_));
  EXPECT_THAT(unknown, HasSubstr("output state unknown: fake source: relay welded"));
}

TEST_F(RecordedRunEnd, KnownStateIsNotReportedAsUnknown) {
  options_.output_unknown = [](const std::string& what) { ADD_FAILURE() << what; };
  EXPECT_EQ(run(one_second(), station_, options_).verdict, Verdict::kPass);
}

TEST_F(RecordedRunEnd, InvalidSettingsEndTheRunBeforeAnyDeviceIsUsed) {
  profile::Plan refused = one_second();
  refused.outlets[1].settings.settings["threshold_mw"] = -1.0;
  EXPECT_THROW(run(refused, station_, options_), profile::ConfigurationError);
  EXPECT_FALSE(station_.was_touched());
  EXPECT_NO_THROW(writer_.begin({})) << "nothing was written";
}

}  // namespace
}  // namespace gsbench::station::test
