// An emulated station's hardware and the lifetime of its folder.
#include "scratch_folder.hpp"
#include <sys/wait.h>
#include <test_support/demand.hpp>
#include <test_support/waiting.hpp>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include <emulation/hardware.hpp>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;
using emulation::Connection;
using emulation::Hardware;
using emulation::HardwareOptions;
using emulation::ScratchFolder;
using testing::HasSubstr;

TEST(ScratchFolder, IsRemovedWithItsFilesByItsOwner) {
  std::string path;
  {
    const std::unique_ptr<ScratchFolder> folder = demand(ScratchFolder::create());
    path = folder->path();
    std::ofstream(path + "/a.terminals") << "samples";
    ASSERT_TRUE(fs::exists(path + "/a.terminals"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolder, IsAccessibleForItsUserOnly) {
  const std::unique_ptr<ScratchFolder> folder = demand(ScratchFolder::create());
  EXPECT_EQ(fs::status(folder->path()).permissions(), fs::perms::owner_all);
}

TEST(ScratchFolder, IsNotRemovedWhileInUse) {
  const std::unique_ptr<ScratchFolder> first = demand(ScratchFolder::create());
  const std::unique_ptr<ScratchFolder> second = demand(ScratchFolder::create());
  EXPECT_NE(first->path(), second->path());
  EXPECT_TRUE(fs::exists(first->path()));
}

TEST(ScratchFolder, IsRemovedByTheNextIfItsOwnerWasKilled) {
  int channel[2];
  ASSERT_EQ(pipe(channel), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    auto made = ScratchFolder::create();
    if (made.ok()) {
      const std::unique_ptr<ScratchFolder> folder = made.take();
      std::ofstream(folder->path() + "/left") << "behind";
      const ssize_t put = ::write(channel[1], folder->path().c_str(), folder->path().size());
      pause();
      _exit(put > 0 ? 0 : 1);
    }
    _exit(1);
  }
  char path[256] = {};
  ASSERT_GT(::read(channel[0], path, sizeof path - 1), 0);
  ::close(channel[0]);
  ::close(channel[1]);
  {
    const auto beside = ScratchFolder::create();
    EXPECT_TRUE(fs::exists(path)) << "its owner is still running";
  }
  ASSERT_EQ(::kill(owner, SIGKILL), 0);
  ASSERT_EQ(waitpid(owner, nullptr, 0), owner);
  EXPECT_TRUE(fs::exists(path));
  const auto next = ScratchFolder::create();
  EXPECT_FALSE(fs::exists(path));
}

HardwareOptions with(std::vector<emulation::HardwareOutlet> outlets) {
  HardwareOptions options;
  options.host_program = GS_OUTLET_PROGRAM;
  options.outlets = std::move(outlets);
  return options;
}

TEST(Hardware, EndsItsProcessesAndRemovesItsFiles) {
  std::vector<pid_t> pids;
  std::string folder;
  {
    const auto hardware = demand(Hardware::set_up(with({{"s"}, {"m", "host", Connection::kMqtt}})));
    pids = {hardware->outlet_process(0).pid(), hardware->outlet_process(1).pid(),
            hardware->broker()->pid()};
    folder = hardware->folder();
    for (const pid_t pid : pids) {
      EXPECT_TRUE(runs(pid));
    }
    EXPECT_EQ(hardware->serial_ports().size(), 1U);
    EXPECT_EQ(hardware->mqtt_ids(), std::vector<std::string>{"m"});
  }
  for (const pid_t pid : pids) {
    EXPECT_FALSE(runs(pid));
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Hardware, StartsNoBrokerWithoutOutletsOnMqtt) {
  EXPECT_EQ(demand(Hardware::set_up(with({{"s"}})))->broker(), nullptr);
}

TEST(Hardware, ReportsWhyItCannotBeSetUp) {
  const auto refusal = [](const HardwareOptions& options) {
    return Hardware::set_up(options).error();
  };
  EXPECT_THAT(refusal(with({{"m4", "mps2-an386", Connection::kMqtt}})),
              HasSubstr("outlet m4: the board mps2-an386 has no radio"));
  EXPECT_THAT(refusal(with({{"f4", "stm32f405"}})),
              HasSubstr("outlet f4: the board \"stm32f405\" cannot be emulated"));
  EXPECT_THAT(refusal(with({{"s"}, {"s"}})), HasSubstr("s.terminals: File exists"));
  HardwareOptions missing = with({{"s"}});
  missing.host_program = "/nowhere/gs-outlet";
  EXPECT_THAT(refusal(missing), HasSubstr("/nowhere/gs-outlet: cannot be started"));
}

}  // namespace
}  // namespace gsbench::test
