// gsbench monitor whose reader stops reading, as a pager does.
#include "gsbench_process.hpp"
#include <fcntl.h>
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>
#include <test_support/waiting.hpp>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <memory>
#include <thread>

#include <gmock/gmock.h>

#include <emulation/hardware.hpp>
#include <station/station_lock.hpp>

namespace gsbench::test {
namespace {

constexpr std::int64_t kReport = 128;  // samples
constexpr std::size_t kRoom_bytes = std::size_t{1} << 20U;
constexpr std::size_t kPipe_bytes = std::size_t{64} << 10U;

class StalledReader : public testing::Test {
 protected:
  StalledReader() {
    EXPECT_EQ(::pipe2(pipe_.data(), O_CLOEXEC), 0);
    emulation::HardwareOptions options;
    options.outlets = {{"a", "host", emulation::Connection::kSerial, 0.0}};
    options.host_program = GS_OUTLET_PROGRAM;
    options.real_time = false;
    hardware_ = demand(emulation::Hardware::set_up(options));
    port_ = hardware_->serial_ports().front();
  }
  ~StalledReader() override {
    over_ = true;
    if (mains_.joinable()) {
      mains_.join();
    }
    ::close(pipe_[0]);
    std::filesystem::remove(station::lock_files(port_).front());
  }

  Started start_monitor(const Words& more) {
    Words words = {"monitor", "--port", port_};
    words.insert(words.end(), more.begin(), more.end());
    Started started = start_gsbench(words, [this] { ::dup2(pipe_[1], STDOUT_FILENO); });
    ::close(pipe_[1]);
    return started;
  }

  // Plays until the end of the test, much faster than in real time.
  void play() {
    mains_ = std::thread([this] {
      Mains mains;
      mains.duration_s = 7200.0;
      start(hardware_->source(), mains);
      for (std::int64_t tick = kReport; !over_ && tick < mains.total_ticks(); tick += kReport) {
        advance(hardware_->source(), tick);
        ++reports_;
      }
    });
  }

  // The next line; empty if the writer has ended.
  std::string read_line() {
    std::array<char, 4096> part{};
    std::size_t end = 0;
    while ((end = read_.find('\n')) == std::string::npos) {
      const ssize_t count = ::read(pipe_[0], part.data(), part.size());
      if (count <= 0) {
        return "";
      }
      read_.append(part.data(), static_cast<std::size_t>(count));
    }
    std::string line = read_.substr(0, end);
    read_.erase(0, end + 1);
    return line;
  }

  static std::size_t memory_kb(pid_t pid) {
    std::ifstream status("/proc/" + std::to_string(pid) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.rfind("VmRSS:", 0) == 0) {
        return std::stoul(line.substr(6));
      }
    }
    return 0;
  }

  std::array<int, 2> pipe_{};
  std::unique_ptr<emulation::Hardware> hardware_;
  std::string port_;
  std::atomic<int> reports_{0};

 private:
  std::string read_;  // and not yet taken
  std::atomic<bool> over_{false};
  std::thread mains_;
};

TEST_F(StalledReader, LearnsHowManyObjectsWereLeftOutAndMemoryIsBounded) {
  const Started started = start_monitor({"--json"});
  EXPECT_THAT(read_line(), testing::HasSubstr("\"joined\",\"id\":\"a\""));
  play();
  // About 180 bytes each: several times what may wait.
  ASSERT_TRUE(until([&] { return reports_ > 10000; }));
  const std::size_t before_kb = memory_kb(started.pid);
  ASSERT_TRUE(until([&] { return reports_ > 30000; }));
  EXPECT_LT(memory_kb(started.pid), before_kb + 2 * kRoom_bytes / 1024);

  std::size_t bytes = 0;
  std::int64_t last = 0;
  json object = json::parse(read_line());
  for (; object["event"] == "message"; object = json::parse(read_line())) {
    last = object["sample"];
    bytes += object.dump().size() + 1;
  }
  ASSERT_EQ(object["event"], "left out") << object;
  EXPECT_GT(bytes, kRoom_bytes);
  EXPECT_LT(bytes, kRoom_bytes + 3 * kPipe_bytes);
  const std::int64_t left_out = object["count"];
  EXPECT_GT(left_out, 1000);
  EXPECT_EQ(json::parse(read_line())["sample"], last + kReport * (left_out + 1));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

TEST_F(StalledReader, DoesNotKeepItFromItsEnd) {
  const Started started = start_monitor({});
  EXPECT_THAT(read_line(), testing::HasSubstr("hello"));
  play();
  ASSERT_TRUE(until([&] { return reports_ > 15000; }));
  EXPECT_EQ(stop(started, SIGTERM).exit_code, 0);
  EXPECT_EQ(station::lock_holder(port_), "");
}

}  // namespace
}  // namespace gsbench::test
