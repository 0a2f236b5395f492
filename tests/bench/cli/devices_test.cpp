// gsbench devices and gsbench monitor with an emulated outlet, on a serial line or behind a broker.
#include "gsbench_process.hpp"
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>
#include <test_support/output_of.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>

#include <emulation/hardware.hpp>
#include <render/layout.hpp>
#include <station/station_lock.hpp>

namespace gsbench::test {
namespace {

using emulation::Connection;
using testing::AllOf;
using testing::HasSubstr;

// An emulated station with one outlet at nominal voltage and frequency, for the duration of a test.
class OneOutlet : public testing::Test {
 protected:
  explicit OneOutlet(Connection connection) : connection_(connection) {}
  void SetUp() override {
    emulation::HardwareOptions options;
    options.outlets = {{"kitchen-1", "host", connection_, 0.0}};
    options.host_program = GS_OUTLET_PROGRAM;
    hardware_ = demand(emulation::Hardware::set_up(options));
    mains_ = std::thread([this] { play(); });
    if (connection_ == Connection::kSerial) {
      where_ = hardware_->serial_ports().front();
      return;
    }
    const auto& broker = *hardware_->broker();
    where_ = broker.url();
    folder_.write("bench.password", broker.bench().password + "\n");
    station_ = folder_.write("station.toml",
                             "title = \"Radio\"\nkind = \"physical\"\n[mqtt]\nurl = \"" + where_ +
                                 "\"\nca_file = \"" + broker.ca_file() + "\"\nuser = \"" +
                                 broker.bench().user + "\"\npassword_file = \"bench.password\"\n");
  }
  void TearDown() override {
    over_ = true;
    if (mains_.joinable()) {
      mains_.join();
    }
    std::filesystem::remove(station::lock_files(where_).front());
  }

  // The command with the options that reach the outlet.
  Words to_it(const std::string& command, const Words& more = {}) const {
    Words words = {command, "--port", where_};
    if (connection_ == Connection::kMqtt) {
      words = {command, "--station", station_};
    }
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  const Connection connection_;
  const TemporaryFolder folder_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::string where_;  // its port, or the broker's URL
  std::string station_;

 private:
  void play() try {
    Mains mains;
    mains.duration_s = 600.0;
    start(hardware_->source(), mains);
    for (std::int64_t tick = 128; !over_; tick += 128) {
      advance(hardware_->source(), tick);
    }
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
  }

  std::atomic<bool> over_{false};
  std::thread mains_;
};

struct SerialStation : OneOutlet {
  SerialStation() : OneOutlet(Connection::kSerial) {}
};
struct MqttStation : OneOutlet {
  MqttStation() : OneOutlet(Connection::kMqtt) {}
};
struct AnyStation : OneOutlet, testing::WithParamInterface<Connection> {
  AnyStation() : OneOutlet(GetParam()) {}
};
INSTANTIATE_TEST_SUITE_P(SerialAndMqtt, AnyStation,
                         testing::Values(Connection::kSerial, Connection::kMqtt));

Words lines_of(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

TEST_P(AnyStation, IsListedWithTheDataThatItsOutletReports) {
  const json found = run_for_json(to_it("devices", {"--json"}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["id"], "kitchen-1");
  EXPECT_EQ(found[0]["where"], where_);
  EXPECT_EQ(found[0]["fault"], "");
  EXPECT_EQ(found[0]["board"], "host");
  EXPECT_EQ(found[0]["sample_rate_hz"], 8000);
  EXPECT_EQ(found[0]["nominal_hz"], 50);
  EXPECT_EQ(found[0]["settings_version"], 0);
  EXPECT_EQ(found[0]["settings_digest"], "00000000");
  EXPECT_EQ(found[0]["keeps_settings"], true);

  const Outcome table = run_gsbench(to_it("devices"));
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("kitchen-1"));
  EXPECT_EQ(lines_of(table.out).size(), 3U);  // two of headings
  for (const char* command : {"devices", "monitor"}) {
    const Words more = {"--seconds", "0.5"};
    for (const std::string& line :
         lines_of(run_on_terminal(to_it(command, command[0] == 'm' ? more : Words{})))) {
      EXPECT_LE(render::columns_of(line), render::kLineColumns) << line;
    }
  }
}

TEST_P(AnyStation, IsMonitoredForTheGivenTime) {
  const Outcome outcome = run_gsbench(to_it("monitor", {"--seconds", "1.5"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Words lines = lines_of(outcome.out);
  // A hello, and most of the measurements of every 16 ms, also on a slow machine.
  ASSERT_GT(lines.size(), 20U);
  EXPECT_THAT(lines.front(), HasSubstr("hello"));
  EXPECT_THAT(lines.front(), HasSubstr("8000 Hz samples of 50 Hz mains, no settings"));
  EXPECT_THAT(lines.back(), testing::StartsWith("kitchen-1"));
  EXPECT_THAT(outcome.out, HasSubstr("50.0000 Hz"));
  EXPECT_THAT(outcome.out, HasSubstr("1.0000 pu valid"));
}

TEST_F(SerialStation, IsMonitoredUntilInterrupted) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(until([&] { return text_of(started.out).find("pu valid") != std::string::npos; }));
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(SerialStation, IsMonitoredUntilTheReaderOfThePipeEnds) {
  const std::string command = "timeout 30 " + std::string(GSBENCH_PROGRAM) + " monitor --port " +
                              where_ + " 2>&1 | head -n 3";
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(lines_of(output_of(command).text).size(), 3U);
  // The shell waits for both processes: without the broken pipe monitor would run for 30 s.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(15));
}

// To read a port that a run uses would spoil the run.
TEST_F(SerialStation, IsNotReadWhileAnotherBenchUsesItsPort) {
  const std::string station = folder_.write(
      "serial.toml",
      "title = \"Serial\"\nkind = \"physical\"\n[serial]\nports = [\"" + where_ + "\"]\n");
  const station::StationLock lock({where_}, "profile paper/loss-500mw");
  for (const Words& words : {to_it("devices"), to_it("monitor", {"--seconds", "1"}),
                             Words{"devices", "--station", station},
                             Words{"monitor", "--station", station, "--seconds", "1"}}) {
    const Outcome outcome = run_gsbench(words);
    EXPECT_EQ(outcome.exit_code, 4) << testing::PrintToString(words);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(where_ + ": in use by another bench: user "),
                                   HasSubstr("profile paper/loss-500mw, since 20")));
  }
}

TEST_F(SerialStation, IsInUseWhileItIsMonitored) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(until([&] { return text_of(started.out).find("pu valid") != std::string::npos; }));
  const Outcome second = run_gsbench(to_it("devices"));
  EXPECT_EQ(second.exit_code, 4);
  EXPECT_THAT(second.err, HasSubstr("(gsbench), command monitor, since 20"));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0) << "it was not disturbed";
  EXPECT_EQ(run_gsbench(to_it("devices")).exit_code, 0);
}

TEST_F(MqttStation, IsListedWhileItIsMonitored) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(until([&] { return text_of(started.out).find("pu valid") != std::string::npos; }));
  EXPECT_EQ(run_gsbench(to_it("devices")).exit_code, 0);
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

TEST_P(AnyStation, HasNoOutletWithAnotherId) {
  expect_refused(to_it("monitor", {"--outlet", "cellar", "--seconds", "1"}),
                 "no outlet cellar answers");
}

TEST_F(SerialStation, ReportsAnOutletThatDoesNotAnswer) {
  hardware_->outlet_process(0).kill();
  const Outcome found = run_gsbench(to_it("devices"));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, HasSubstr("! " + where_ + ": does not answer"));
  expect_refused(to_it("monitor"), "no outlet answers");
}

TEST_F(MqttStation, RefusesAWrongPassword) {
  folder_.write("bench.password", "guessed\n");
  const Outcome outcome = run_gsbench(to_it("monitor", {"--seconds", "1"}));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("refuses the user name"));
}

TEST_F(MqttStation, ReportsAMissingOutletAndListsTheOther) {
  std::ofstream(station_, std::ios::app) << "outlets = [\"cellar\", \"kitchen-1\"]\n";
  const Outcome outcome = run_gsbench(to_it("devices"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.out, testing::ContainsRegex("! cellar at .*: is not on the broker"));
  EXPECT_THAT(outcome.out, HasSubstr("kitchen-1"));
  expect_refused(to_it("monitor", {"--outlet", "cellar"}), "no outlet cellar answers");
}

TEST(Devices, AMissingPortIsNamed) {
  for (const char* command : {"devices", "monitor"}) {
    expect_refused({command, "--port", "/dev/ttyNowhere7"}, "/dev/ttyNowhere7: No such file");
  }
}

TEST(Devices, AStationWithOutletsOnlyDuringARunIsRefused) {
  expect_refused({"devices", "--station", "simulated"}, "can be reached without a run");
  expect_refused({"monitor", "--station", "emulatd"}, "\"emulated\"");
}

}  // namespace
}  // namespace gsbench::test
