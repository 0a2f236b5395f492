// gsbench monitor with emulated outlets, on a serial line or behind a broker.
#include "live_outlets.hpp"
#include <link_test/bench_options.hpp>
#include <test_support/output_of.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct OnSerialLine : LiveOutlets {
  OnSerialLine() : LiveOutlets(Connection::kSerial) {}
};
struct BehindABroker : LiveOutlets {
  BehindABroker() : LiveOutlets(Connection::kMqtt) {}

  // What the broker stores of sessions.
  std::string stored() {
    const auto asked = std::filesystem::file_time_type::clock::now();
    ::kill(hardware_->broker()->pid(), SIGUSR1);
    const std::string file = hardware_->broker()->memory_file();
    EXPECT_TRUE(until([&] {
      std::error_code missing;
      return std::filesystem::last_write_time(file, missing) > asked;
    }));
    return text_of(file);
  }
};
struct AnyOutlet : LiveOutlets, testing::WithParamInterface<Connection> {
  AnyOutlet() : LiveOutlets(GetParam()) {}
};
INSTANTIATE_TEST_SUITE_P(SerialAndMqtt, AnyOutlet,
                         testing::Values(Connection::kSerial, Connection::kMqtt));

Words keys_of(const std::string& line) {
  Words keys;
  const auto object = nlohmann::ordered_json::parse(line);
  for (const auto& [key, value] : object.items()) {
    keys.push_back(key);
  }
  return keys;
}

TEST_P(AnyOutlet, IsMonitoredForTheGivenTime) {
  const Outcome outcome = run_gsbench(to_it("monitor", {"--seconds", "1.5"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Words lines = lines_of(outcome.out);
  // A hello, and most of the measurements of every 16 ms, also on a slow machine.
  ASSERT_GT(lines.size(), 20U);
  EXPECT_THAT(lines.front(), HasSubstr("hello"));
  EXPECT_THAT(lines.front(), HasSubstr("8000 Hz samples of 50 Hz mains, no settings"));
  EXPECT_THAT(lines.back(), testing::StartsWith("kitchen-1"));
  EXPECT_THAT(outcome.out, HasSubstr("50.0000 Hz"));
  EXPECT_THAT(outcome.out, HasSubstr("1.0000 pu valid"));
}

TEST_F(OnSerialLine, IsMonitoredUntilInterrupted) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(shows(started, "pu valid"));
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(OnSerialLine, IsMonitoredUntilTheReaderOfThePipeEnds) {
  const std::string command = "timeout 30 " + std::string(GSBENCH_PROGRAM) + " monitor --port " +
                              where_ + " 2>&1 | head -n 3";
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(lines_of(output_of(command).text).size(), 3U);
  // The shell waits for both processes: without the broken pipe monitor would run for 30 s.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(15));
}

TEST_F(OnSerialLine, IsInUseWhileItIsMonitored) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(shows(started, "pu valid"));
  const Outcome second = run_gsbench(to_it("devices"));
  EXPECT_EQ(second.exit_code, 4);
  EXPECT_THAT(second.err, HasSubstr("(gsbench), command monitor, since 20"));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0) << "it was not disturbed";
  EXPECT_EQ(run_gsbench(to_it("devices")).exit_code, 0);
}

TEST_F(BehindABroker, IsListedWhileItIsMonitored) {
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(shows(started, "pu valid"));
  EXPECT_EQ(run_gsbench(to_it("devices")).exit_code, 0);
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

TEST_P(AnyOutlet, IsMonitoredAsOneJsonObjectOnEachLine) {
  const Outcome outcome = run_gsbench(to_it("monitor", {"--seconds", "1.5", "--json"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Words lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 20U);
  const json joined = json::parse(lines.front());
  EXPECT_EQ(joined["event"], "joined");
  EXPECT_EQ(joined["id"], "kitchen-1");
  EXPECT_EQ(joined["where"], where_);
  EXPECT_EQ(joined["sample_rate_hz"], 8000);
  EXPECT_EQ(keys_of(lines.front()), (Words{"event",           "id",
                                           "where",           "fault",
                                           "protocol",        "board",
                                           "instance",        "firmware",
                                           "build",           "sample_rate_hz",
                                           "nominal_hz",      "tracker_delay_s",
                                           "voltage_delay_s", "settings_version",
                                           "settings_digest", "keeps_settings",
                                           "has_watchdog",    "session",
                                           "next_number",     "arrival_s",
                                           "start_number",    "sample",
                                           "format_version"}));
  EXPECT_EQ(joined["format_version"], 1);
  EXPECT_GT(joined["tracker_delay_s"].get<double>(), 0.0);
  EXPECT_GT(joined["voltage_delay_s"].get<double>(), 0.0);
  const std::string measurement = *std::find_if(lines.begin(), lines.end(), [](const auto& line) {
    return line.find("measurement") != std::string::npos;
  });
  const json first = json::parse(measurement);
  EXPECT_EQ(keys_of(measurement),
            (Words{"event", "id", "arrival_s", "start_number", "sequence", "sample", "kind",
                   "frequency_hz", "rocof_hz_s", "voltage_pu", "validity"}));
  // The hello is of the same start and clock, and arrived before.
  EXPECT_EQ(joined["start_number"], first["start_number"]);
  EXPECT_NEAR(joined["sample"].get<double>(), first["sample"].get<double>(), 80000.0);
  EXPECT_LE(joined["arrival_s"].get<double>(), first["arrival_s"].get<double>());
  std::uint32_t sequence = first["sequence"].get<std::uint32_t>();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const json message = json::parse(lines[i]);
    EXPECT_EQ(message["event"], "message") << lines[i];
    EXPECT_EQ(message["id"], "kitchen-1");
    if (message["kind"] != "hello") {
      EXPECT_EQ(message["sequence"], sequence++);
    }
    if (message["kind"] == "measurement" && message["validity"] == "valid") {
      EXPECT_NEAR(message["frequency_hz"].get<double>(), 50.0, 0.01);
      EXPECT_NEAR(message["voltage_pu"].get<double>(), 1.0, 0.01);
    }
  }
  EXPECT_EQ(json::parse(lines.back())["kind"], "measurement");
}

TEST_F(OnSerialLine, IsMonitoredByItsIdAndOthersAreNot) {
  const Words more = {"--seconds", "0.5"};
  Words words = to_it("monitor", more);
  words.insert(words.begin() + 1, "kitchen-1");
  EXPECT_THAT(run_gsbench(words).out, HasSubstr("kitchen-1"));
  words[1] = "cellar";
  words.insert(words.end(), {"--wait", "4"});
  const Outcome outcome = run_gsbench(words);
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("waiting for outlet cellar on " + where_ + ", 4 s at most"),
                    HasSubstr("outlet \"cellar\" did not answer within 4 s")));
}

TEST_F(OnSerialLine, IsShownOnceItAnswers) {
  hardware_->outlet_process(0).kill();
  const Started started = start_gsbench(to_it("monitor", {"--wait", "600"}));
  EXPECT_TRUE(says(started, "waiting for an outlet on " + where_ + ", 600 s at most"));
  EXPECT_TRUE(shows(started, where_ + " ! does not answer"));
  demand(hardware_->restart_outlet(0));
  EXPECT_TRUE(shows(started, "8000 Hz samples of 50 Hz mains"));
  EXPECT_TRUE(shows(started, "measurement"));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

TEST_F(BehindABroker, LeavesNothingAtTheBrokerHoweverItIsEnded) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const Started started = start_gsbench(to_it("monitor"));
    EXPECT_TRUE(shows(started, "pu valid"));
    EXPECT_EQ(stored().find("gsbench-"), std::string::npos);
    stop(started, signal);
    EXPECT_EQ(stored().find("gsbench-"), std::string::npos) << signal;
  }
  // A run's session, in contrast, outlives a broken connection.
  gsbench::link::MqttLink run(bench_options(*hardware_->broker(), {}));
  ASSERT_TRUE(run.open().ok());
  EXPECT_NE(stored().find("gsbench-"), std::string::npos);
  run.close();
  const auto closed = std::chrono::steady_clock::now();
  EXPECT_TRUE(until([&] { return stored().find("gsbench-") == std::string::npos; }));
  EXPECT_LT(std::chrono::steady_clock::now() - closed, std::chrono::seconds(40)) << "it expired";
}

TEST_F(OnSerialLine, RefusesAPortInPlaceOfAnId) {
  for (const std::string& wrong : {where_, std::string("/dev/ttyUSB0"), std::string(33, 'x')}) {
    expect_refused({"monitor", wrong}, wrong + " is not the id of an outlet");
    expect_refused({"monitor", "--outlet", wrong}, wrong + " is not the id of an outlet");
  }
}

TEST_F(OnSerialLine, RefusesTimesThatAreNone) {
  for (const char* option : {"--seconds", "--wait"}) {
    for (const char* time : {"nan", "-nan", "inf", "0", "-1", "1e400", "2 s", "x", ""}) {
      expect_refused(to_it("monitor", {option, time}), option);
    }
  }
}

}  // namespace
}  // namespace gsbench::test
