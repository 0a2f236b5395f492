// `gsbench safe`, and refusals of `run`, on physical stations: against an emulated generator and an
// emulated head.
#include "gsbench_process.hpp"
#include <head_driver_test/running_head.hpp>
#include <test_support/mains.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <emulation/generator.hpp>
#include <station/station_lock.hpp>

namespace gsbench::test {
namespace {

using emulation::Generator;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class SafeCommand : public testing::Test {
 protected:
  SafeCommand() {
    auto started = Generator::start({});
    EXPECT_TRUE(started.ok()) << started.error();
    generator_ = started.take();
    switch_on();
  }

  void switch_on() const {
    emulation::PanelChange on;
    on.output_on = true;
    generator_->press(on);
    EXPECT_TRUE(generator_->output_is_on());
  }

  std::string station(const std::string& port,
                      const std::string& instrument = "siglent-sdg2000x") const {
    return folder_.write(instrument + ".toml",
                         fmt::format("title = \"A generator\"\nkind = \"physical\"\n[source]\n"
                                     "kind = \"scpi\"\nport = \"{}\"\n"
                                     "instrument = \"{}\"\ngain = 100.0\n"
                                     "voltage_limit_v = 350.0\nboot_s = 1.0\n"
                                     "[[outlet]]\nplace = \"socket-1\"\n"
                                     "link = \"/dev/gsbench-nowhere\"\n",
                                     port, instrument));
  }
  std::string station() const { return station(generator_->port()); }

  // Two seconds of nominal frequency; `more` are keys of [signal].
  std::string profile(const std::string& more = "") const {
    return folder_.write("short.toml",
                         "title = \"Short\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n"
                         "[signal]\nduration_s = 2.0\n" +
                             more + "[[outlet]]\n[[expect]]\nmeasure = \"event.count\"\nmax = 0\n");
  }

  const TemporaryFolder folder_;
  std::unique_ptr<Generator> generator_;
};

TEST_F(SafeCommand, SwitchesTheOutputOffAlsoTwice) {
  for (int time = 0; time < 2; ++time) {
    const Outcome outcome = run_gsbench({"safe", station()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(StartsWith(generator_->port() + ": "), HasSubstr("SDG2000X"),
                                   HasSubstr(": output off\n")));
    EXPECT_FALSE(generator_->output_is_on());
  }
}

TEST_F(SafeCommand, WaitsForAnInstrumentThatReboots) {
  generator_->reset_now(std::chrono::milliseconds(1500));
  const Outcome outcome = run_gsbench({"safe", station(), "--wait", "60"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_FALSE(generator_->output_is_on());
}

TEST_F(SafeCommand, SaysThatTheStateIsUnknownIfNobodyAnswers) {
  const std::string path = station();
  generator_->unplug();
  const Outcome outcome = run_gsbench({"safe", path, "--wait", "0"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("output state unknown"), HasSubstr(generator_->port()),
                                 HasSubstr("Switch the generator off by hand"),
                                 HasSubstr("The outlets may be live."),
                                 Not(HasSubstr("switch the source off by hand"))));
  EXPECT_EQ(outcome.out, "");
}

// Attempts begin 0.5 s apart at least.
TEST_F(SafeCommand, WaitBoundsTheAttempts) {
  generator_->clear_messages();
  emulation::GeneratorFaults stuck;
  stuck.ignores_output_off = true;
  generator_->set_faults(stuck);
  const auto identified = [&] {
    const auto messages = generator_->messages();
    return std::count(messages.begin(), messages.end(), "*IDN?");
  };
  EXPECT_EQ(run_gsbench({"safe", station(), "--wait", "0"}).exit_code, 4);
  EXPECT_EQ(identified(), 1);
  EXPECT_EQ(run_gsbench({"safe", station(), "--wait", "3"}).exit_code, 4);
  EXPECT_GE(identified(), 1 + 2);
  EXPECT_LE(identified(), 1 + 6);
}

TEST_F(SafeCommand, RefusesAWaitThatHasNoEnd) {
  for (const char* wait : {"nan", "-1", "inf", "1e9", "3601"}) {
    expect_refused({"safe", station(), "--wait", wait}, "is not a number from 0 to 3600");
  }
  EXPECT_TRUE(generator_->output_is_on());
}

// It would wait for two answers, 2 s each.
TEST_F(SafeCommand, AnInterruptEndsItAtOnceAndSaysThatTheStateIsUnknown) {
  generator_->clear_messages();
  emulation::GeneratorFaults silent;
  silent.silent = true;
  silent.ignores_output_off = true;
  generator_->set_faults(silent);
  const Started started = start_gsbench({"safe", station(), "--wait", "60"});
  EXPECT_TRUE(until([&] { return !generator_->messages().empty(); }));
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("output state unknown"), HasSubstr("by hand")));
  EXPECT_EQ(generator_->messages().size(), 1U) << "it ended while it waited for the first answer";
}

TEST_F(SafeCommand, AHangUpDoesNotEndIt) {
  emulation::GeneratorFaults slow;
  slow.answer_delay_s = 0.5;
  generator_->clear_messages();
  generator_->set_faults(slow);
  const Started started = start_gsbench({"safe", station()});
  EXPECT_TRUE(until([&] { return !generator_->messages().empty(); }));
  EXPECT_EQ(stop(started, SIGHUP).exit_code, 0);
  EXPECT_FALSE(generator_->output_is_on());
}

TEST_F(SafeCommand, SaysThatTheStateIsUnknownIfTheOutputStaysOn) {
  emulation::GeneratorFaults stuck;
  stuck.ignores_output_off = true;
  generator_->set_faults(stuck);
  const Outcome outcome = run_gsbench({"safe", station(), "--wait", "0"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("output state unknown"));
}

TEST_F(SafeCommand, WarnsWhoUsesTheStationAndGoesOn) {
  const std::string port = generator_->port();
  {
    const station::StationLock lock({port}, "profile paper/loss-500mw");
    const Outcome outcome = run_gsbench({"safe", station()});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("in use by another bench"), HasSubstr("profile paper/loss-500mw")));
    EXPECT_FALSE(generator_->output_is_on());
  }
  std::filesystem::remove(station::lock_files(port).front());
}

TEST_F(SafeCommand, RefusesAStationWithoutASource) {
  expect_refused({"safe", "simulated"}, "no source that outlives the bench");
  expect_refused({"safe", "serial"}, "no source that outlives the bench");
}

TEST_F(SafeCommand, RunOnAStationInUseIsAnError) {
  const std::string port = generator_->port();
  {
    const station::StationLock lock({port}, "profile paper/loss-500mw");
    const Outcome outcome =
        run_gsbench({"run", profile(), "--station", station(), "--out", folder_.file("runs")});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(port + ": in use by another bench: user "),
                                   HasSubstr("profile paper/loss-500mw")));
  }
  std::filesystem::remove(station::lock_files(port).front());
}

TEST_F(SafeCommand, DryRunPrintsThePlanAndSendsNothing) {
  generator_->clear_messages();
  const Outcome outcome = run_gsbench({"run", profile(), "--station", station(), "--dry-run"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("nothing was energised"), HasSubstr("SDG2000X"),
                    HasSubstr("(tolerance 2)"), HasSubstr("not calibrated"),
                    HasSubstr("place socket-1, link /dev/gsbench-nowhere, contact not sensed")));
  EXPECT_TRUE(generator_->messages().empty());
  EXPECT_TRUE(generator_->output_is_on()) << "as it was";
}

TEST_F(SafeCommand, DryRunIsAvailableAsJson) {
  const json plan = run_for_json({"run", profile(), "--station", station(), "--dry-run", "--json"});
  EXPECT_EQ(plan["outlets"].size(), 1U);
  EXPECT_EQ(plan["outlets"][0]["place"], "socket-1");
  EXPECT_EQ(plan["boot_s"], 1.0);
  EXPECT_EQ(plan["markers_before_s"], 2.8);
  EXPECT_GT(plan["source"]["frequency_mhz"], 0.0);
  EXPECT_LE(plan["source"]["frequency_mhz"], plan["source"]["frequency_tolerance_mhz"]);
}

TEST_F(SafeCommand, DryRunRefusesATighterTolerance) {
  expect_refused(
      {"run", profile("frequency_tolerance_mhz = 1e-9\n"), "--station", station(), "--dry-run"},
      "mHz");
}

// The memory of the second station's generator is too small.
TEST_F(SafeCommand, CompareRefusesAStationBeforeItPlaysAtAnother) {
  generator_->clear_messages();
  expect_refused({"compare", profile(), "--station", station(), "--station",
                  station("tcp://127.0.0.1:9", "siglent-sdg1000x")},
                 "SDG1000X");
  EXPECT_TRUE(generator_->messages().empty());
}

// The head's time stands still, so that it does not switch off because its bench is silent.
TEST(SafeOnAHead, SwitchesTheOutputOff) {
  RunningHead head(HeadPace::kRealTime);
  const auto bench = demand(head::Head::create(options_for(*head)));
  const Mains mains;
  demand(bench->source().prepare(mains));
  demand(bench->source().energise());
  demand(bench->source().hold());
  head.freeze();
  EXPECT_EQ(head->observe().state, gs::head::State::kPlaying);
  const TemporaryFolder folder;
  const std::string station = folder.write(
      "bench.toml", fmt::format("title = \"A head\"\nkind = \"physical\"\n[source]\n"
                                "kind = \"head\"\nport = \"{}\"\ngain = 247.6\n"
                                "voltage_limit_v = 252.0\n[[outlet]]\nplace = \"socket-1\"\n"
                                "link = \"/dev/gsbench-nowhere\"\n",
                                head->port()));
  const Outcome outcome = run_gsbench({"safe", station, "--wait", "0"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith(head->port() + ": "), HasSubstr(": output off\n")));
  EXPECT_EQ(head->observe().state, gs::head::State::kOff);
}

}  // namespace
}  // namespace gsbench::test
