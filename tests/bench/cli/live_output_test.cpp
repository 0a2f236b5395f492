// Signals while the output of a physical source is on.
#include "gsbench_process.hpp"
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <csignal>
#include <memory>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <emulation/generator.hpp>
#include <emulation/listening.hpp>
#include <station/station_lock.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A run that waits, with the output on, for an outlet that accepts a connection and says nothing.
class LiveRun : public testing::Test {
 protected:
  LiveRun()
      : generator_(demand(emulation::Generator::start({}))),
        outlet_(demand(emulation::LoopbackPort::reserve())),
        outlet_port_(fmt::format("tcp://127.0.0.1:{}", outlet_.number())) {
    demand(outlet_.listen());
    station_ = folder_.write("bench.toml",
                             fmt::format("title = \"A generator\"\nkind = \"physical\"\n[source]\n"
                                         "kind = \"scpi\"\nport = \"{}\"\n"
                                         "instrument = \"siglent-sdg2000x\"\ngain = 100.0\n"
                                         "voltage_limit_v = 350.0\nboot_s = 60.0\n"
                                         "[[outlet]]\nplace = \"socket-1\"\nlink = \"{}\"\n",
                                         generator_->port(), outlet_port_));
    profile_ = folder_.write(
        "short.toml",
        "title = \"Short\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
        "duration_s = 2.0\n[[outlet]]\n[[expect]]\nmeasure = \"event.count\"\nmax = 0\n");
  }
  ~LiveRun() override {
    for (const std::string& port : {generator_->port(), outlet_port_}) {
      std::filesystem::remove(station::lock_files(port).front());
    }
  }

  Started start_until_live(const std::function<void()>& prepare = [] {}) const {
    Started started = start_gsbench(
        {"run", profile_, "--station", station_, "--out", folder_.file("runs")}, prepare);
    EXPECT_TRUE(until([&] { return generator_->output_is_on(); }));
    return started;
  }

  const TemporaryFolder folder_;
  std::unique_ptr<emulation::Generator> generator_;
  emulation::LoopbackPort outlet_;
  std::string outlet_port_;
  std::string station_;
  std::string profile_;
};

TEST_F(LiveRun, EverySignalThatEndsItSwitchesTheOutputOff) {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGHUP}) {
    const Outcome outcome = stop(start_until_live(), signal);
    EXPECT_EQ(outcome.exit_code, 130) << signal << outcome.err;
    EXPECT_FALSE(generator_->output_is_on()) << signal;
    EXPECT_THAT(outcome.err, Not(HasSubstr("output state unknown"))) << signal;
  }
}

TEST_F(LiveRun, HangUpsThatFollowEachOtherDoNotKillIt) {
  const Started started = start_until_live();
  for (int time = 0; time < 20; ++time) {
    kill(started.pid, SIGHUP);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(stop(started, SIGHUP).exit_code, 130);
  EXPECT_FALSE(generator_->output_is_on());
}

TEST_F(LiveRun, NohupKeepsItGoing) {
  const Started started = start_until_live([] { std::signal(SIGHUP, SIG_IGN); });
  kill(started.pid, SIGHUP);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_TRUE(generator_->output_is_on());
  EXPECT_EQ(stop(started, SIGINT).exit_code, 130);
}

TEST_F(LiveRun, PrintsWhatItWaitsForAlsoOnAPipe) {
  const Started started = start_until_live();
  EXPECT_TRUE(until([&] {
    return text_of(started.err).find("waiting for outlets: 0 of 1 joined") != std::string::npos;
  }));
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_THAT(outcome.err, Not(HasSubstr("\r")));
  EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 7) << "for 60 s at most";
}

TEST_F(LiveRun, SecondSignalSaysThatTheStateIsUnknownBeforeItEndsTheBench) {
  const Started started = start_until_live();
  generator_->unplug();
  kill(started.pid, SIGINT);
  const Outcome outcome = stop(started, SIGTERM);
  EXPECT_TRUE(outcome.exit_code == 128 + SIGTERM || outcome.exit_code == 128 + SIGINT)
      << outcome.exit_code;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(generator_->port()), HasSubstr("output state unknown"),
                                 HasSubstr("gsbench safe " + station_), HasSubstr("unplug it")));
}

TEST_F(LiveRun, ReportThatCannotBeWrittenDoesNotHideThatTheStateIsUnknown) {
  const Started started = start_until_live();
  // A folder is in the place of the report.
  std::filesystem::create_directory(only_run(folder_.path() / "runs") / "report.html");
  generator_->unplug();
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  const std::size_t report = outcome.err.find("report.html: ");
  ASSERT_NE(report, std::string::npos) << outcome.err;
  EXPECT_LT(outcome.err.find("output state unknown"), report) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("output state unknown"));
}

}  // namespace
}  // namespace gsbench::test
