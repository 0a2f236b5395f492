// An emulated station's hardware, and its folder: in use, left behind, removed.
#include "scratch_folder.hpp"
#include "waiting.hpp"
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/hardware.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::emulation::Connection;
using gsbench::emulation::Hardware;
using gsbench::emulation::HardwareOptions;
using gsbench::emulation::ScratchFolder;
using testing::HasSubstr;

TEST(ScratchFolder, GoesWithItsOwnerAndAllThatIsInIt) {
  std::string path;
  {
    auto made = ScratchFolder::create();
    ASSERT_TRUE(made.ok()) << made.error();
    const ScratchFolder folder = made.take();
    path = folder.path();
    std::ofstream(path + "/a.terminals") << "samples";
    ASSERT_TRUE(fs::exists(path + "/a.terminals"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolder, CanBeReadByNobodyElse) {
  const auto made = ScratchFolder::create();
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_EQ(fs::status(made.value().path()).permissions(), fs::perms::owner_all);
}

TEST(ScratchFolder, InUseIsLeftAlone) {
  const auto first = ScratchFolder::create();
  ASSERT_TRUE(first.ok());
  const auto second = ScratchFolder::create();
  ASSERT_TRUE(second.ok());
  EXPECT_NE(first.value().path(), second.value().path());
  EXPECT_TRUE(fs::exists(first.value().path()));
}

TEST(ScratchFolder, OfAKilledOwnerIsRemovedByTheNext) {
  int told[2];
  ASSERT_EQ(pipe(told), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    auto made = ScratchFolder::create();
    if (made.ok()) {
      const ScratchFolder folder = made.take();
      std::ofstream(folder.path() + "/left") << "behind";
      const ssize_t put = ::write(told[1], folder.path().c_str(), folder.path().size());
      pause();
      _exit(put > 0 ? 0 : 1);
    }
    _exit(1);
  }
  char path[256] = {};
  ASSERT_GT(::read(told[0], path, sizeof path - 1), 0);
  ::close(told[0]);
  ::close(told[1]);
  {
    const auto beside = ScratchFolder::create();
    EXPECT_TRUE(fs::exists(path)) << "its owner still lives";
  }
  ASSERT_EQ(::kill(owner, SIGKILL), 0);
  ASSERT_EQ(waitpid(owner, nullptr, 0), owner);
  EXPECT_TRUE(fs::exists(path));
  const auto next = ScratchFolder::create();
  EXPECT_FALSE(fs::exists(path));
}

HardwareOptions options() {
  HardwareOptions options;
  options.host_program = GS_OUTLET_PROGRAM;
  return options;
}

TEST(Hardware, EndsItsOutletsBrokerAndFilesWithItself) {
  HardwareOptions two = options();
  two.outlets = {{"s", "host", Connection::kSerial, 0.0}, {"m", "host", Connection::kMqtt, 0.0}};
  std::vector<pid_t> pids;
  std::string folder;
  {
    auto made = Hardware::set_up(two);
    ASSERT_TRUE(made.ok()) << made.error();
    const auto hardware = made.take();
    pids = {hardware->outlet_process(0).pid(), hardware->outlet_process(1).pid(),
            hardware->broker()->pid()};
    folder = hardware->folder();
    for (const pid_t pid : pids) {
      EXPECT_TRUE(gsbench::test::runs(pid));
    }
    EXPECT_EQ(hardware->serial_ports().size(), 1U);
    EXPECT_EQ(hardware->mqtt_ids(), std::vector<std::string>{"m"});
  }
  for (const pid_t pid : pids) {
    EXPECT_FALSE(gsbench::test::runs(pid));
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Hardware, WithoutOutletsOnMqttHasNoBroker) {
  HardwareOptions one = options();
  one.outlets = {{"s", "host", Connection::kSerial, 0.0}};
  auto made = Hardware::set_up(one);
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_EQ(made.value()->broker(), nullptr);
}

TEST(Hardware, TellsWhatItCannotSetUp) {
  HardwareOptions radio = options();
  radio.outlets = {{"m4", "mps2-an386", Connection::kMqtt, 0.0}};
  EXPECT_THAT(Hardware::set_up(radio).error(),
              HasSubstr("outlet m4: the board mps2-an386 has no radio"));
  HardwareOptions unknown = options();
  unknown.outlets = {{"f4", "stm32f405", Connection::kSerial, 0.0}};
  EXPECT_THAT(Hardware::set_up(unknown).error(),
              HasSubstr("outlet f4: no board \"stm32f405\" can be emulated"));
  HardwareOptions missing = options();
  missing.host_program = "/nowhere/gs-outlet";
  missing.outlets = {{"s", "host", Connection::kSerial, 0.0}};
  EXPECT_THAT(Hardware::set_up(missing).error(),
              HasSubstr("/nowhere/gs-outlet: cannot be started"));
  HardwareOptions twice = options();
  twice.outlets = {{"s", "host", Connection::kSerial, 0.0},
                   {"s", "host", Connection::kSerial, 0.0}};
  EXPECT_THAT(Hardware::set_up(twice).error(), HasSubstr("s.terminals: File exists"));
}

}  // namespace
