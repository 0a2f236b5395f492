// Failures of outlets and cables during a run with real emulators, processes and a broker. What
// each run must fulfil is checked in station_of_four.cpp.
#include "station_of_four.hpp"
#include <shared_memory_io/shared_memory.hpp>
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <csignal>
#include <cstring>

#include <emulation/child.hpp>
#include <emulation/mains.hpp>
#include <link/wait_for_outlets.hpp>

namespace gsbench::station::test {
namespace {

using gsbench::test::Bytes;
using gsbench::test::change_hello;
using gsbench::test::demand;
using gsbench::test::every_nth_byte;
using gsbench::test::Spoiling;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

class OutletFault : public FaultyStation {
 protected:
  // True if the outlet is up before the fault is injected.
  bool answers(Place outlet) {
    const std::string name = *station_->slots()[outlet].link_id;
    const auto present =
        link::wait_for_outlets(station_->link(), {name}, station_->answers_within());
    station_->link().close();
    return present.ok() && present.value().front().fault.empty();
  }
};

TEST_F(OutletFault, IsAbsentInAnUndisturbedRunAndTheRecordHasAllLinks) {
  play();
  expect_all_complete();
  EXPECT_THAT(record_.outlets[kM4].link, StartsWith("tcp://127.0.0.1:"));
  EXPECT_THAT(record_.outlets[kHost].link, StartsWith("tcp://127.0.0.1:"));
  EXPECT_NE(record_.outlets[kM4].link, record_.outlets[kHost].link);
  EXPECT_EQ(record_.outlets[kRadioA].link, hardware().broker()->url());
  EXPECT_EQ(record_.outlets[kRadioB].link, hardware().broker()->url());
  EXPECT_EQ(record_.outlets[kM4].id, "m4");
  EXPECT_EQ(record_.outlets[kRadioB].id, "radio-b");
}

TEST_F(OutletFault, KilledEmulatorStopsReporting) {
  at(0.5, [&] { hardware().outlet_process(kM4).kill(); });
  play();
  expect_fault(kM4, "stopped reporting after its sample ");
}

TEST_F(OutletFault, EmulatorThatIsStartedAgainIsReported) {
  at(0.5, [&] { kill_and_restart(kM4); });
  play();
  expect_faults({{kM4, ""}});
  // A board sends byte by byte: the kill may truncate a frame, which is then the first fault.
  EXPECT_THAT(record_.outlets[kM4].fault,
              AnyOf(HasSubstr("restarted after its sample "), HasSubstr("sent a damaged frame")));
}

TEST_F(OutletFault, ProcessThatIsStartedAgainIsReportedAsRestarted) {
  at(0.5, [&] { kill_and_restart(kHost); });
  play();
  expect_fault(kHost, "restarted after its sample ");
}

TEST_F(OutletFault, ProcessBehindTheBrokerThatIsStartedAgainIsReported) {
  at(0.5, [&] { kill_and_restart(kRadioB); });
  play();
  expect_faults({{kRadioB, ""}});
  EXPECT_THAT(record_.outlets[kRadioB].fault,
              AnyOf(HasSubstr("left the broker"), HasSubstr("restarted after its sample ")));
}

// After a restart the sample count starts at 0 again: later reports would get wrong times.
TEST_F(OutletFault, RecordEndsAtTheRestartOfAnOutlet) {
  at(0.6, [&] { kill_and_restart(kHost); });
  play();
  const std::vector<std::int64_t>& ticks = record_.outlets[kHost].reports.trace.tick;
  ASSERT_FALSE(ticks.empty());
  EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
  EXPECT_LT(ticks.back(), plan_.duration_ticks());
}

TEST_F(OutletFault, SuspendedProcessStopsReporting) {
  at(0.5, [&] { ASSERT_EQ(::kill(hardware().outlet_process(kHost).pid(), SIGSTOP), 0); });
  play();
  expect_fault(kHost, "stopped reporting after its sample ");
}

class SpoiledCable : public FaultyStation, public testing::WithParamInterface<Spoiling> {};

TEST_P(SpoiledCable, IsReportedForItsOutletOnly) {
  at(0.5, [&] { hardware().cable(kM4).spoil(every_nth_byte(97, GetParam().spoil)); });
  play();
  // Detected by the damaged frame or by the missing sequence number.
  expect_faults({{kM4, ""}});
  EXPECT_THAT(record_.outlets[kM4].fault,
              AnyOf(HasSubstr("sent a damaged frame"), HasSubstr("of its messages were lost")));
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpoiledCable, testing::ValuesIn(gsbench::test::kSpoilings),
                         [](const auto& kind) { return kind.param.name; });

TEST_F(OutletFault, OutletWithAnotherProtocolIsSentNoSettings) {
  hardware().cable(kHost).spoil(
      change_hello([](gs::wire::Hello& hello) { hello.protocol_version = 77; }));
  play();
  expect_fault(kHost, "uses protocol version 77, not ");
  EXPECT_TRUE(record_.outlets[kHost].settings.empty()) << "it was sent settings";
  EXPECT_TRUE(record_.outlets[kHost].reports.trace.tick.empty())
      << "its reports cannot be interpreted";
}

TEST_F(OutletFault, SilentOutletIsExcluded) {
  hardware().cable(kHost).spoil([](Bytes& bytes) { bytes.clear(); });
  play();
  expect_fault(kHost, "does not answer");
  EXPECT_EQ(record_.outlets[kHost].id, "host");
  EXPECT_EQ(record_.outlets[kHost].link, hardware().serial_ports()[kHost]);
  EXPECT_TRUE(record_.outlets[kHost].measurements.empty()) << "it was excluded";
  EXPECT_TRUE(record_.outlets[kHost].reports.trace.tick.empty());
}

TEST_F(OutletFault, OutletOnTheBrokerThatDoesNotAnswerIsExcluded) {
  ASSERT_TRUE(answers(kRadioA));
  ASSERT_EQ(::kill(hardware().outlet_process(kRadioA).pid(), SIGSTOP), 0);
  play();
  expect_fault(kRadioA, "does not answer");
  EXPECT_TRUE(record_.outlets[kRadioA].settings.empty()) << "it was sent settings";
}

TEST_F(OutletFault, OutletMissingFromTheBrokerIsExcluded) {
  ASSERT_TRUE(answers(kRadioB));
  hardware().outlet_process(kRadioB).kill();
  play();
  expect_fault(kRadioB, "is not on the broker");
}

// The bench cannot know which of the two the profile means.
TEST_F(OutletFault, TwoSerialOutletsWithTheSameIdAreBothExcluded) {
  hardware().cable(kHost).spoil(
      change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, "m4"); }));
  play();
  expect_faults(
      {{kM4, "has the same id as another outlet: the one on " + hardware().serial_ports()[kHost]},
       {kHost, "has the same id as another outlet: the one on " + hardware().serial_ports()[kM4]}});
  for (const Place twin : {kM4, kHost}) {
    EXPECT_EQ(record_.outlets[twin].id, "m4 on " + hardware().serial_ports()[twin]);
    EXPECT_TRUE(record_.outlets[twin].settings.empty()) << "it was sent settings";
  }
}

TEST_F(OutletFault, SerialOutletWithTheIdOfOneBehindTheBrokerIsReported) {
  hardware().cable(kHost).spoil(
      change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, "radio-a"); }));
  play();
  expect_faults({{kHost, "has the same id as another outlet: the one on "},
                 {kRadioA, "has the same id as another outlet: the one on "}});
}

// Another device with the same id may join a broker at any time.
TEST_F(OutletFault, DuplicateThatJoinsDuringARunIsReportedForItsIdOnly) {
  const gsbench::test::TemporaryFolder folder;
  emulation::MainsOptions options;
  options.folder = folder.path().string();
  options.outlets = {{"spacer", 0.0},
                     {"spacer-2", 0.0},
                     {"spacer-3", 0.0},
                     {"spacer-4", 0.0},
                     {"radio-b", 0.0}};  // the fifth instance, which the station does not have
  const auto mains = demand(emulation::Mains::create(options));
  std::unique_ptr<emulation::Child> twin;
  at(0.5, [&] {
    const emulation::Login& login = hardware().broker()->outlet("radio-b");
    twin = std::make_unique<emulation::Child>(demand(emulation::Child::start(
        {{GS_OUTLET_PROGRAM, "--mqtt", hardware().broker()->url(), "--ca",
          hardware().broker()->ca_file(), "--user", login.user, "--password-file",
          folder.write("password", login.password + "\n"), "--terminals", mains->terminal_path(4),
          "--doorbell", mains->doorbell_path(4)},
         ""})));
  });
  play();
  expect_fault(kRadioB, "has the same id as another outlet: ");
}

TEST_F(OutletFault, MissingCrystalIsReported) {
  hardware().terminals(kM4).crystal_fails = 1;
  kill_and_restart(kM4);
  play();
  expect_fault(kM4, "crystal");  // as its own error report or by its self test
}

TEST_F(OutletFault, LostSamplesAreReported) {
  at(0.4, [&] { ASSERT_EQ(::kill(hardware().outlet_process(kHost).pid(), SIGSTOP), 0); });
  at(0.5, [&] {
    // More samples than its buffer holds, in less time than the limit for silence.
    hardware().terminals(kHost).written += 2 * gs::shared_memory_io::kRingSamples;
    ASSERT_EQ(::kill(hardware().outlet_process(kHost).pid(), SIGCONT), 0);
  });
  play();
  expect_fault(kHost, "reported the error: samples lost");
}

// Link, relay sense and source must refer to the same outlet in any order of the station's list.
TEST_F(OutletFault, IsAbsentIfTheStationListsMqttOutletsFirst) {
  Outlets outlets = station_of_four();
  std::rotate(outlets.begin(), outlets.begin() + 2, outlets.end());
  plan_ = plan(1.5, "noise_pct = 1.0\n",
               "[[outlet]]\nid = \"cut\"\n[[outlet]]\ncount = 3\nid = \"left\"\n"
               "[[command]]\nat_s = 0.5\noutlets = [\"cut\"]\nswitch = \"off\"\n");
  set_up(outlets);
  play();
  expect_all_complete();
  for (const record::OutletRecord& outlet : record_.outlets) {
    std::vector<std::string> relay_marks;
    for (const record::Mark& mark : outlet.reports.marks) {
      if (mark.kind.rfind("relay.", 0) == 0) {
        relay_marks.push_back(mark.kind);
      }
    }
    if (outlet.group == "cut") {
      EXPECT_THAT(relay_marks, testing::UnorderedElementsAre("relay.reported", "relay.sense"));
    } else {
      EXPECT_THAT(relay_marks, testing::IsEmpty()) << outlet.id;
    }
  }
}

}  // namespace
}  // namespace gsbench::station::test
