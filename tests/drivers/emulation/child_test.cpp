// Child processes end with the bench.
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <fstream>

#include <gmock/gmock.h>

#include <emulation/child.hpp>

namespace gsbench::test {
namespace {

using emulation::Child;
using testing::HasSubstr;

Child started(const std::vector<std::string>& words, const std::string& output = {}) {
  return demand(Child::start({words, output}));
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
  const std::string pid_file = folder.file("pid");
  Child owner = started({CHILD_OWNER_PROGRAM, pid_file});
  ASSERT_TRUE(until([&] { return std::ifstream(pid_file).good(); }));
  pid_t grandchild = 0;
  std::ifstream(pid_file) >> grandchild;
  ASSERT_TRUE(runs(grandchild));
  owner.kill();
  EXPECT_TRUE(until([&] { return !runs(grandchild); }));
}

TEST(Child, IsKilledIfItIgnoresSigterm) {
  const TemporaryFolder folder;
  const std::string ready = folder.file("ready");
  Child child = started({"sh", "-c", "trap '' TERM; : > " + ready + "; while :; do sleep 1; done"});
  const pid_t pid = child.pid();
  ASSERT_TRUE(until([&] { return std::ifstream(ready).good(); }));
  child.stop();
  EXPECT_FALSE(child.running());
  EXPECT_FALSE(runs(pid));
}

TEST(Child, EndsEvenIfStoppedBySigstop) {
  Child child = started({"sleep", "1000"});
  const pid_t pid = child.pid();
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  child.stop();
  EXPECT_FALSE(runs(pid));
}

TEST(Child, IsNotRunningAfterItHasEnded) {
  Child child = started({"true"});
  EXPECT_TRUE(until([&] { return !child.running(); }));
}

TEST(Child, ReportsWhyItCannotBeStarted) {
  EXPECT_EQ(Child::start({{"/nowhere/no-such-program"}, ""}).error(),
            "/nowhere/no-such-program: cannot be started: No such file or directory");
}

TEST(Child, ReportsWhyItsOutputFileCannotBeOpened) {
  EXPECT_THAT(Child::start({{"true"}, "/nowhere/output"}).error(),
              HasSubstr("No such file or directory"));
}

TEST(Child, WritesItsOutputToItsFile) {
  const TemporaryFolder folder;
  Child child = started({"sh", "-c", "echo out; echo err >&2"}, folder.file("log"));
  ASSERT_TRUE(until([&] { return !child.running(); }));
  EXPECT_EQ(folder.read("log"), "out\nerr\n");
}

}  // namespace
}  // namespace gsbench::test
