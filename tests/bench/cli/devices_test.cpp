// gsbench devices with emulated outlets, on serial lines or behind a broker.
#include "live_outlets.hpp"
#include "spoilers.hpp"
#include <test_support/output_of.hpp>
#include <test_support/waiting.hpp>

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>

#include <gmock/gmock.h>

#include <emulation/listening.hpp>
#include <render/layout.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct SerialStation : LiveOutlets {
  SerialStation() : LiveOutlets(Connection::kSerial) {}
};
struct MqttStation : LiveOutlets {
  MqttStation() : LiveOutlets(Connection::kMqtt) {}
};
struct AnyStation : LiveOutlets, testing::WithParamInterface<Connection> {
  AnyStation() : LiveOutlets(GetParam()) {}
};
INSTANTIATE_TEST_SUITE_P(SerialAndMqtt, AnyStation,
                         testing::Values(Connection::kSerial, Connection::kMqtt));

TEST_P(AnyStation, IsListedWithTheDataThatItsOutletReports) {
  const json found = run_for_json(to_it("devices", {"--json"}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["format_version"], 1);
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

TEST_F(SerialStation, ReportsAnOutletThatDoesNotAnswer) {
  hardware_->outlet_process(0).kill();
  const Outcome found = run_gsbench(to_it("devices"));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, HasSubstr("! " + where_ + ": does not answer"));
}

TEST_F(MqttStation, ReportsAMissingOutletAndListsTheOther) {
  std::ofstream(station_, std::ios::app) << "outlets = [\"cellar\", \"kitchen-1\"]\n";
  const Outcome outcome = run_gsbench(to_it("devices"));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.out, testing::ContainsRegex("! cellar at .*: is not on the broker"));
  EXPECT_THAT(outcome.out, HasSubstr("kitchen-1"));
}

TEST_F(MqttStation, TakesAPasswordFileOfAnotherEditor) {
  folder_.write("bench.password",
                "\xEF\xBB\xBF" + hardware_->broker()->bench().password + "\r\nsecond line\r\n");
  EXPECT_EQ(run_gsbench(to_it("devices")).exit_code, 0);
}

TEST_F(MqttStation, RefusesAWrongPasswordAndAMissingCaFile) {
  folder_.write("bench.password", "guessed\n");
  for (const Words& words : {to_it("devices"), to_it("monitor", {"--seconds", "1"})}) {
    const Outcome outcome = run_gsbench(words);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("refuses the user name"));
  }
  std::filesystem::remove(hardware_->broker()->ca_file());
  expect_refused(to_it("devices"), station_ + ":5:11: ca_file is ");
  expect_refused(to_it("monitor"), station_ + ":5:11: ca_file is ");
}

struct TwoOnSerialLines : LiveOutlets {
  TwoOnSerialLines()
      : LiveOutlets(Connection::kSerial, {"kitchen-1", "a-name-of-thirty-two-characters1"}) {}
};

TEST_F(TwoOnSerialLines, ALongIdDoesNotBreakTheTable) {
  const Outcome table = run_gsbench(to_it("devices"));
  EXPECT_EQ(table.exit_code, 0) << table.err;
  const Words lines = lines_of(table.out);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[3], ids_[1]);
  EXPECT_EQ(lines[2].find("host"), lines[4].find("host"));
  EXPECT_EQ(lines[2].find("tcp://"), lines[4].find("tcp://"));
  for (const Words& words : {to_it("devices"), to_it("monitor", {"--seconds", "0.5"})}) {
    for (const std::string& line : lines_of(run_on_terminal(words))) {
      EXPECT_LE(render::columns_of(line), render::kLineColumns) << line;
    }
  }
}

TEST_F(TwoOnSerialLines, APortThatCannotBeOpenedIsAtFaultAndTheOthersAreListed) {
  const auto closed = demand(emulation::LoopbackPort::reserve());
  const std::string refusing = "tcp://127.0.0.1:" + std::to_string(closed.number());
  const std::string file = folder_.write("a-file-and-no-port-" + std::string(150, 'x'), "text");
  const Words more = {"--port", "/dev/ttyNowhere7", "--port", file, "--port", refusing};
  const Outcome found = run_gsbench(to_it("devices", more));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, AllOf(HasSubstr("kitchen-1"), HasSubstr("! /dev/ttyNowhere7: "),
                               HasSubstr("No such file or directory"),
                               HasSubstr("! " + file + ": "), HasSubstr("is not a serial port"),
                               HasSubstr("! " + refusing + ": "), HasSubstr("Connection refused")));
  Words words = to_it("devices", more);
  words.emplace_back("--json");
  const json listed = json::parse(run_gsbench(words).out);
  ASSERT_EQ(listed.size(), 5U);
  EXPECT_EQ(listed[1]["id"], ids_[1]);
  EXPECT_EQ(listed[1]["sample_rate_hz"], 8000);
  for (std::size_t i = 2; i < 5; ++i) {
    EXPECT_EQ(listed[i].size(), 3U) << listed[i];
    EXPECT_EQ(listed[i]["where"], more[2 * i - 3]);
    EXPECT_NE(listed[i]["fault"], "");
  }
}

TEST_F(TwoOnSerialLines, APortInUseIsAtFaultAndTheOtherIsListed) {
  const station::StationLock lock({where_}, "profile paper/loss-500mw");
  const Outcome found = run_gsbench(to_it("devices"));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, AllOf(HasSubstr(ids_[1]),
                               HasSubstr("! " + where_ + ": in use by another bench: user "),
                               HasSubstr("profile paper/loss-500mw")));
}

TEST_F(TwoOnSerialLines, TwoNamesOfOnePortAreOnePort) {
  const std::string other = "tcp://localhost" + where_.substr(where_.rfind(':'));
  const std::string third = "TCP" + where_.substr(3) + '/';
  const json found =
      run_for_json({"devices", "--port", where_, "--port", other, "--port", third, "--json"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["where"], where_);
}

TEST_F(TwoOnSerialLines, OutletsWithTheSameIdAreReportedAlikeByBothCommands) {
  hardware_->cable(1).spoil(
      change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, "kitchen-1"); }));
  const std::string other = hardware_->serial_ports()[1];
  const Outcome found = run_gsbench(to_it("devices"));
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_EQ(lines_of(found.out),
            (Words{"! kitchen-1 at " + where_ + ": has the same id as another outlet: the one on " +
                       other,
                   "! kitchen-1 at " + other + ": has the same id as another outlet: the one on " +
                       where_}));
  for (const json& listed : json::parse(run_gsbench(to_it("devices", {"--json"})).out)) {
    EXPECT_EQ(listed["id"], "kitchen-1");
    EXPECT_EQ(listed["board"], "host");
  }
  const Outcome shown = run_gsbench(to_it("monitor", {"--seconds", "1", "--wait", "5"}));
  for (const auto& [one, two] : {std::pair(where_, other), {other, where_}}) {
    EXPECT_THAT(lines_of(shown.out),
                testing::Contains(
                    AllOf(testing::StartsWith("kitchen-1 at " + one + " ! "),
                          HasSubstr("has the same id as another outlet: the one on " + two))));
  }
}

TEST(Devices, AMissingPortIsAFaultAndATextThatIsNoPortIsRefused) {
  for (const Words& words : {Words{"devices"}, Words{"monitor", "--wait", "0.1"}}) {
    Words missing = words;
    missing.insert(missing.end(), {"--port", "/dev/ttyNowhere8"});
    const Outcome outcome = run_gsbench(missing);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_THAT(outcome.out, HasSubstr("/dev/ttyNowhere8"));
    EXPECT_THAT(outcome.out, HasSubstr("No such file or directory"));
    Words none = words;
    none.insert(none.end(), {"--port", "COM7"});
    expect_refused(none, "COM7: is neither of the form tcp://host:port nor the path of a device");
    none.back() = "";
    expect_refused(none, "--port: the value is empty");
  }
}

TEST(Devices, ASymbolicLinkToAPortIsThatPort) {
  const TemporaryFolder folder;
  const std::string port = folder.write("ttyUSB0", "");
  const std::string link = folder.file("by-id");
  std::filesystem::create_symlink("ttyUSB0", link);
  const Words both = {"devices", "--port", link, "--port", port, "--json"};
  const json listed = json::parse(run_gsbench(both).out);
  ASSERT_EQ(listed.size(), 1U) << listed;
  EXPECT_EQ(listed[0]["where"], link);
  EXPECT_THAT(listed[0]["fault"].get<std::string>(), HasSubstr("is not a serial port"));
  const station::StationLock lock({port}, "profile first");
  EXPECT_THAT(run_gsbench({"monitor", "--port", link}).err,
              HasSubstr(link + ": in use by another bench: user "));
  std::filesystem::remove(station::lock_files(port).front());
}

TEST(Devices, AStationWithOutletsOnlyDuringARunIsRefused) {
  expect_refused({"devices", "--station", "simulated"}, "can be reached without a run");
  expect_refused({"monitor", "--station", "emulatd"}, "\"emulated\"");
}

}  // namespace
}  // namespace gsbench::test
