// What finds outlets and listens to them, on an emulated line or behind a broker.
#include "gsbench_process.hpp"
#include <sys/wait.h>
#include <test_support/mains.hpp>
#include <test_support/temporary_folder.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <emulation/hardware.hpp>

namespace {

using gsbench::emulation::Connection;
using gsbench::emulation::Hardware;
using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using gsbench::test::start_gsbench;
using gsbench::test::Started;
using gsbench::test::text_of;
using testing::HasSubstr;

// Calm mains of an emulated station with one outlet, for as long as a test lasts.
class SerialStation : public testing::Test {
 protected:
  void SetUp() override { set_up(Connection::kSerial); }
  void set_up(Connection connection) {
    gsbench::emulation::HardwareOptions options;
    options.outlets = {{"kitchen-1", "host", connection, 0.0}};
    options.host_program = GS_OUTLET_PROGRAM;
    auto hardware = Hardware::set_up(options);
    ASSERT_TRUE(hardware.ok()) << hardware.error();
    hardware_ = hardware.take();
    mains_ = std::thread([this] { play(); });
  }
  void TearDown() override {
    over_ = true;
    if (mains_.joinable()) {
      mains_.join();
    }
  }

  std::string port() const { return hardware_->serial_ports().front(); }

  std::unique_ptr<Hardware> hardware_;

 private:
  void play() {
    gsbench::test::Mains mains;
    mains.duration_s = 600.0;
    gsbench::test::start(hardware_->source(), mains);
    for (std::int64_t tick = 128; !over_; tick += 128) {
      gsbench::test::advance(hardware_->source(), tick);
    }
  }

  std::atomic<bool> over_{false};
  std::thread mains_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

// Until it has printed that, and no longer than anything here could take.
bool prints(const Started& started, const std::string& what) {
  for (int tries = 0; tries < 2000; ++tries) {
    if (text_of(started.out).find(what) != std::string::npos) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST_F(SerialStation, IsFoundWithWhatItsOutletSaysOfItself) {
  const Outcome outcome = run_gsbench({"devices", "--port", port(), "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto found = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["id"], "kitchen-1");
  EXPECT_EQ(found[0]["where"], port());
  EXPECT_EQ(found[0]["board"], "host");
  EXPECT_EQ(found[0]["sample_rate_hz"], 8000);
  EXPECT_EQ(found[0]["nominal_hz"], 50);
  EXPECT_EQ(found[0]["settings_version"], 0);
  EXPECT_EQ(found[0]["settings_digest"], "00000000");
  EXPECT_EQ(found[0]["keeps_settings"], true);

  const Outcome table = run_gsbench({"devices", "--port", port()});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("kitchen-1"));
  EXPECT_EQ(lines_of(table.out).size(), 2U);
}

TEST_F(SerialStation, IsHeardForAsLongAsAsked) {
  const Outcome outcome = run_gsbench({"monitor", "--port", port(), "--seconds", "1.5"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  // A hello, and of the measurements every 16 ms most, on however slow a machine.
  ASSERT_GT(lines.size(), 20U);
  EXPECT_THAT(lines.front(), HasSubstr("hello"));
  EXPECT_THAT(lines.front(), HasSubstr("8000 Hz samples of 50 Hz mains, no settings"));
  EXPECT_THAT(lines.back(), testing::StartsWith("kitchen-1"));
  EXPECT_THAT(outcome.out, HasSubstr("50.0000 Hz"));
  EXPECT_THAT(outcome.out, HasSubstr("1.0000 pu valid"));
}

TEST_F(SerialStation, IsHeardLiveUntilInterrupted) {
  const Started started = start_gsbench({"monitor", "--port", port()});
  EXPECT_TRUE(prints(started, "pu valid"));
  kill(started.pid, SIGINT);
  const Outcome outcome = gsbench::test::wait_for(started);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(SerialStation, IsHeardNoLongerThanAnybodyReads) {
  const std::string command = "timeout 30 " + std::string(GSBENCH_PROGRAM) + " monitor --port " +
                              port() + " 2>&1 | head -n 3";
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::string said;
  for (char part[256]; std::fgets(part, sizeof part, pipe) != nullptr;) {
    said += part;
  }
  const auto began = std::chrono::steady_clock::now();
  pclose(pipe);
  EXPECT_EQ(lines_of(said).size(), 3U);
  // The shell waits for both; without an end of its own the monitor would go on to the 30 s.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(15));
}

TEST_F(SerialStation, HasNoOutletOfAnotherName) {
  const Outcome outcome =
      run_gsbench({"monitor", "--port", port(), "--outlet", "cellar", "--seconds", "1"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no outlet cellar answers"));
}

TEST_F(SerialStation, WithItsOutletGoneHasNothingToFind) {
  hardware_->outlet_process(0).kill();
  const Outcome found = run_gsbench({"devices", "--port", port()});
  EXPECT_EQ(found.exit_code, 4) << found.err;
  EXPECT_THAT(found.out, testing::ContainsRegex(port() + " +! does not answer"));
  const Outcome heard = run_gsbench({"monitor", "--port", port()});
  EXPECT_EQ(heard.exit_code, 2);
  EXPECT_THAT(heard.err, HasSubstr("no outlet answers"));
}

class MqttStation : public SerialStation {
 protected:
  void SetUp() override {
    set_up(Connection::kMqtt);
    const auto& broker = *hardware_->broker();
    folder_.write("bench.password", broker.bench().password + "\n");
    station_ = folder_.write(
        "station.toml", "title = \"Radio\"\nkind = \"physical\"\n[mqtt]\nurl = \"" + broker.url() +
                            "\"\nca_file = \"" + broker.ca_file() + "\"\nuser = \"" +
                            broker.bench().user + "\"\npassword_file = \"bench.password\"\n");
  }

  gsbench::test::TemporaryFolder folder_;
  std::string station_;
};

TEST_F(MqttStation, IsFoundWithWhatItsOutletSaysOfItself) {
  const Outcome outcome = run_gsbench({"devices", "--station", station_, "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto found = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["id"], "kitchen-1");
  EXPECT_EQ(found[0]["where"], hardware_->broker()->url());
  EXPECT_EQ(found[0]["fault"], "");
}

TEST_F(MqttStation, IsHeardForAsLongAsAsked) {
  const Outcome outcome = run_gsbench({"monitor", "--station", station_, "--seconds", "1.5"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 20U);
  EXPECT_THAT(lines.front(), HasSubstr("hello"));
  EXPECT_THAT(outcome.out, HasSubstr("1.0000 pu valid"));
}

TEST_F(MqttStation, WithAWrongPasswordIsNotListenedTo) {
  folder_.write("bench.password", "guessed\n");
  const Outcome outcome = run_gsbench({"monitor", "--station", station_, "--seconds", "1"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("refuses the user name"));
}

// An outlet that was named and is not there is told, and the one that is there is shown.
TEST_F(MqttStation, AnOutletThatWasNamedAndIsNotThereIsTold) {
  std::ofstream(station_, std::ios::app) << "outlets = [\"cellar\", \"kitchen-1\"]\n";
  const Outcome outcome = run_gsbench({"devices", "--station", station_});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.out, HasSubstr("! is not on the broker"));
  EXPECT_THAT(outcome.out, HasSubstr("kitchen-1"));
  const Outcome heard = run_gsbench({"monitor", "--station", station_, "--outlet", "cellar"});
  EXPECT_EQ(heard.exit_code, 2);
  EXPECT_THAT(heard.err, HasSubstr("no outlet cellar answers"));
}

TEST(Devices, APortThatDoesNotExistIsToldByItsName) {
  for (const char* command : {"devices", "monitor"}) {
    const Outcome outcome = run_gsbench({command, "--port", "/dev/ttyNowhere7"});
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr("/dev/ttyNowhere7: No such file")) << command;
  }
}

TEST(Devices, AStationWithoutOutletsOfItsOwnIsRefused) {
  const Outcome outcome = run_gsbench({"devices", "--station", "simulated"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("only while a run plays"));
  const Outcome unknown = run_gsbench({"monitor", "--station", "emulatd"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("\"emulated\""));
}

}  // namespace
