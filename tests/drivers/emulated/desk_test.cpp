// A desk's folder: in use, left behind, removed.
#include "desk_folder.hpp"
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

#include <emulated/desk.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::emulated::Board;
using gsbench::emulated::Connection;
using gsbench::emulated::Desk;
using gsbench::emulated::DeskFolder;
using gsbench::emulated::DeskOptions;
using testing::HasSubstr;

TEST(DeskFolder, GoesWithItsOwnerAndAllThatIsInIt) {
  std::string path;
  {
    auto made = DeskFolder::create();
    ASSERT_TRUE(made.ok()) << made.error();
    const DeskFolder folder = made.take();
    path = folder.path();
    std::ofstream(path + "/a.terminals") << "samples";
    ASSERT_TRUE(fs::exists(path + "/a.terminals"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(DeskFolder, CanBeReadByNobodyElse) {
  const auto made = DeskFolder::create();
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_EQ(fs::status(made.value().path()).permissions(), fs::perms::owner_all);
}

TEST(DeskFolder, InUseIsLeftAlone) {
  const auto first = DeskFolder::create();
  ASSERT_TRUE(first.ok());
  const auto second = DeskFolder::create();
  ASSERT_TRUE(second.ok());
  EXPECT_NE(first.value().path(), second.value().path());
  EXPECT_TRUE(fs::exists(first.value().path()));
}

TEST(DeskFolder, OfAKilledOwnerIsRemovedByTheNext) {
  int told[2];
  ASSERT_EQ(pipe(told), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    auto made = DeskFolder::create();
    if (made.ok()) {
      const DeskFolder folder = made.take();
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
    const auto beside = DeskFolder::create();
    EXPECT_TRUE(fs::exists(path)) << "its owner still lives";
  }
  ASSERT_EQ(::kill(owner, SIGKILL), 0);
  ASSERT_EQ(waitpid(owner, nullptr, 0), owner);
  EXPECT_TRUE(fs::exists(path));
  const auto next = DeskFolder::create();
  EXPECT_FALSE(fs::exists(path));
}

DeskOptions options() {
  DeskOptions options;
  options.host_program = GS_OUTLET_PROGRAM;
  return options;
}

TEST(Desk, EndsItsOutletsBrokerAndFilesWithItself) {
  DeskOptions two = options();
  two.outlets = {{"s", Board::kHost, Connection::kSerial, 0.0},
                 {"m", Board::kHost, Connection::kMqtt, 0.0}};
  std::vector<pid_t> pids;
  std::string folder;
  {
    auto made = Desk::set_up(two);
    ASSERT_TRUE(made.ok()) << made.error();
    const auto desk = made.take();
    pids = {desk->outlet_process(0).pid(), desk->outlet_process(1).pid(), desk->broker()->pid()};
    folder = desk->folder();
    for (const pid_t pid : pids) {
      EXPECT_TRUE(gsbench::test::runs(pid));
    }
    EXPECT_EQ(desk->serial_ports().size(), 1U);
    EXPECT_EQ(desk->mqtt_ids(), std::vector<std::string>{"m"});
  }
  for (const pid_t pid : pids) {
    EXPECT_FALSE(gsbench::test::runs(pid));
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Desk, WithoutOutletsOnMqttHasNoBroker) {
  DeskOptions one = options();
  one.outlets = {{"s", Board::kHost, Connection::kSerial, 0.0}};
  auto made = Desk::set_up(one);
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_EQ(made.value()->broker(), nullptr);
}

TEST(Desk, TellsWhatItCannotSetUp) {
  DeskOptions radio = options();
  radio.outlets = {{"m4", Board::kMps2An386, Connection::kMqtt, 0.0}};
  EXPECT_THAT(Desk::set_up(radio).error(), HasSubstr("outlet m4: the emulated board has no radio"));
  DeskOptions missing = options();
  missing.host_program = "/nowhere/gs-outlet";
  missing.outlets = {{"s", Board::kHost, Connection::kSerial, 0.0}};
  EXPECT_THAT(Desk::set_up(missing).error(), HasSubstr("/nowhere/gs-outlet: cannot be started"));
  DeskOptions twice = options();
  twice.outlets = {{"s", Board::kHost, Connection::kSerial, 0.0},
                   {"s", Board::kHost, Connection::kSerial, 0.0}};
  EXPECT_THAT(Desk::set_up(twice).error(), HasSubstr("s.terminals: File exists"));
}

}  // namespace
