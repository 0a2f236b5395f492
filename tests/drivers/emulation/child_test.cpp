// Programs that run beside the bench end with it.
#include "waiting.hpp"
#include <test_support/temporary_folder.hpp>

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/child.hpp>

namespace {

using gsbench::emulation::Child;
using gsbench::test::runs;
using gsbench::test::TemporaryFolder;
using gsbench::test::until;
using testing::HasSubstr;

Child started(const std::vector<std::string>& words, const std::string& output = {}) {
  auto child = Child::start({words, output});
  if (!child.ok()) {
    throw std::runtime_error(child.error());
  }
  return child.take();
}

TEST(Child, EndsWithTheObjectThatOwnsIt) {
  pid_t pid = 0;
  {
    Child child = started({"sleep", "1000"});
    pid = child.pid();
    EXPECT_TRUE(child.running());
    EXPECT_TRUE(runs(pid));
  }
  EXPECT_FALSE(runs(pid));
}

TEST(Child, EndsWhenItsOwnersProcessIsKilled) {
  const TemporaryFolder folder;
  const std::string told = folder.file("pid");
  Child owner = started({CHILD_OWNER_PROGRAM, told});
  ASSERT_TRUE(until([&] { return std::ifstream(told).good(); }));
  pid_t grandchild = 0;
  std::ifstream(told) >> grandchild;
  ASSERT_TRUE(runs(grandchild));
  owner.kill();
  EXPECT_TRUE(until([&] { return !runs(grandchild); }));
}

TEST(Child, ThatIgnoresTheTerminationSignalIsKilled) {
  const TemporaryFolder folder;
  const std::string ready = folder.file("ready");
  Child child = started({"sh", "-c", "trap '' TERM; : > " + ready + "; while :; do sleep 1; done"});
  const pid_t pid = child.pid();
  ASSERT_TRUE(until([&] { return std::ifstream(ready).good(); }));
  child.stop();
  EXPECT_FALSE(child.running());
  EXPECT_FALSE(runs(pid));
}

TEST(Child, ThatIsStoppedByASignalEndsNevertheless) {
  Child child = started({"sleep", "1000"});
  const pid_t pid = child.pid();
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  child.stop();
  EXPECT_FALSE(runs(pid));
}

TEST(Child, ThatEndsByItselfIsNoLongerRunning) {
  Child child = started({"true"});
  EXPECT_TRUE(until([&] { return !child.running(); }));
}

TEST(Child, ThatCannotBeStartedIsToldWithItsReason) {
  const auto child = Child::start({{"/nowhere/no-such-program"}, ""});
  ASSERT_FALSE(child.ok());
  EXPECT_EQ(child.error(),
            "/nowhere/no-such-program: cannot be started: No such file or directory");
}

TEST(Child, WhoseOutputCannotBeWrittenIsToldWithItsReason) {
  const auto child = Child::start({{"true"}, "/nowhere/output"});
  ASSERT_FALSE(child.ok());
  EXPECT_THAT(child.error(), HasSubstr("No such file or directory"));
}

TEST(Child, WritesIntoItsFile) {
  const TemporaryFolder folder;
  Child child = started({"sh", "-c", "echo out; echo err >&2"}, folder.file("log"));
  ASSERT_TRUE(until([&] { return !child.running(); }));
  std::ifstream log(folder.file("log"));
  std::string first;
  std::string second;
  std::getline(log, first);
  std::getline(log, second);
  EXPECT_EQ(first, "out");
  EXPECT_EQ(second, "err");
}

}  // namespace
