// One bench at a time uses a port; the kernel releases a lock with its process.
#include "fake_station.hpp"
#include "plans.hpp"
#include <sys/stat.h>
#include <sys/wait.h>
#include <test_support/refusal.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <station/run.hpp>
#include <station/station_lock.hpp>

namespace gsbench::station::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Lock : public testing::Test {
 protected:
  // Ports of this process, so that tests that run at the same time do not meet.
  std::string port(const std::string& name) {
    const int pid = ::getpid();
    const std::string port =
        fmt::format("tcp://127.{}.{}.{}:{}", pid >> 16U & 255U, pid >> 8U & 255U, pid & 255U, name);
    return known(port);
  }

  // Its files are removed after the test.
  std::string known(const std::string& port) {
    for (const std::string& file : lock_files(port)) {
      files_.push_back(file);
    }
    return port;
  }

  ~Lock() override {
    for (const std::string& file : files_) {
      std::filesystem::remove(file);
    }
  }

 private:
  std::vector<std::string> files_;
};

std::string refusal_of(const std::vector<std::string>& ports) {
  return gsbench::test::refusal_of<StationBusy>(
      [&] { const StationLock lock(ports, "profile second"); });
}

TEST_F(Lock, SecondBenchIsRefusedAndSaysWhoUsesThePort) {
  const std::string one = port("1");
  const StationLock lock({one, port("2")}, "profile paper/loss-500mw");
  EXPECT_THAT(refusal_of({port("3"), one}),
              AllOf(StartsWith(one + ": in use by another bench: user "),
                    HasSubstr("process " + std::to_string(::getpid()) + " (gsbench), "),
                    HasSubstr("profile paper/loss-500mw, since 20")));
  EXPECT_EQ(refusal_of({port("3")}), "") << "the lock that was not obtained held nothing";
}

TEST_F(Lock, EndsWithItsObject) {
  const std::string one = port("1");
  { const StationLock lock({one}, "profile first"); }
  EXPECT_EQ(refusal_of({one}), "");
  EXPECT_EQ(lock_holder(one), "");
}

TEST_F(Lock, HolderIsKnownWithoutDisturbingIt) {
  const std::string one = port("1");
  EXPECT_EQ(lock_holder(one), "") << "a port that was never used";
  const StationLock lock({one}, "profile first");
  for (int time = 0; time < 2; ++time) {
    EXPECT_THAT(lock_holder(one), HasSubstr("profile first"));
  }
  EXPECT_NE(refusal_of({one}), "");
}

TEST_F(Lock, PortsThatAreEmptyOrListedTwiceCountOnce) {
  const std::string one = port("1");
  const StationLock lock({"", one, one}, "profile first");
  EXPECT_NE(refusal_of({one}), "");
}

TEST_F(Lock, IsReleasedByTheKernelIfTheBenchIsKilled) {
  const std::string one = port("1");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const StationLock lock({one}, "profile killed");
    (void)!::write(ready[1], "x", 1);
    while (true) {
      ::pause();
    }
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THAT(lock_holder(one), HasSubstr("process " + std::to_string(child)));
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ::close(ready[0]);
  ::close(ready[1]);
  EXPECT_EQ(refusal_of({one}), "");
}

TEST_F(Lock, FileMayBeUsedByAllUsers) {
  const std::string one = port("1");
  const StationLock lock({one}, "profile first");
  struct stat state {};
  ASSERT_EQ(::stat(lock_files(one).front().c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 0777U, 0666U);
}

TEST_F(Lock, TwoNamesOfADeviceHaveOneLock) {
  const gsbench::test::TemporaryFolder folder;
  const std::string device = folder.write("ttyUSB0", "");
  const std::string link = folder.file("by-id");
  std::filesystem::create_symlink(device, link);
  EXPECT_EQ(lock_files(link), lock_files(device));
  EXPECT_NE(lock_files(device + "1"), lock_files(device));
}

TEST_F(Lock, TwoNamesOfAHostHaveOneLock) {
  const std::string number = std::to_string(::getpid());  // as a port; nothing is opened
  const std::string name = known("tcp://localhost:" + number);
  const std::string address = known("tcp://127.0.0.1:" + number);
  {
    const StationLock lock({name}, "profile first");
    EXPECT_THAT(refusal_of({address}), HasSubstr("profile first"));
    EXPECT_THAT(lock_holder(address), HasSubstr("profile first"));
    EXPECT_EQ(refusal_of({address + "1"}), "");
    known(address + "1");
  }
  const StationLock lock({address}, "profile second");
  EXPECT_THAT(refusal_of({name}), HasSubstr("profile second"));
}

TEST_F(Lock, TwoFormsOfAnIpv6AddressHaveOneLock) {
  EXPECT_EQ(lock_files("tcp://[::1]:7"), lock_files("tcp://[0:0::1]:7"));
  EXPECT_EQ(lock_files("tcp://[::1]:7"), lock_files("TCP://[::1]:7/"));
  EXPECT_NE(lock_files("tcp://[::1]:7"), lock_files("tcp://[::2]:7"));
  EXPECT_EQ(lock_files("mqtts://[::1]:8883/a"), lock_files("mqtt://[0:0::1]:1883/a"));
}

TEST_F(Lock, HostThatCannotBeLookedUpIsLockedByItsName) {
  const std::string nowhere = known("tcp://no such host:" + std::to_string(::getpid()));
  const StationLock lock({nowhere}, "profile first");
  EXPECT_NE(refusal_of({nowhere}), "");
}

TEST_F(Lock, OutletBehindABrokerIsLockedWithAndWithoutTls) {
  const std::string id = "outlet-" + std::to_string(::getpid());
  const std::string outlet = known("mqtts://localhost:8883/" + id);
  const StationLock lock({outlet}, "profile first");
  EXPECT_THAT(refusal_of({known("mqtt://127.0.0.1:1883/" + id)}), HasSubstr("profile first"));
  EXPECT_EQ(refusal_of({known("mqtts://localhost:8883/" + id + "2")}), "");
}

TEST_F(Lock, RunIsRefusedBeforeAnythingIsTouched) {
  const std::string one = port("1");
  const StationLock lock({one}, "profile first");
  Script script;
  script.ports = {one};
  FakeStation station(script);
  EXPECT_THROW((void)run(plan(0.5), station, {}), StationBusy);
  EXPECT_FALSE(station.was_touched());
}

TEST_F(Lock, RunReleasesItsLock) {
  const std::string one = port("1");
  Script script;
  script.ports = {one};
  FakeStation station(script);
  EXPECT_EQ(run(plan(0.5), station, {}).verdict, record::Verdict::kPass);
  EXPECT_EQ(lock_holder(one), "");
}

}  // namespace
}  // namespace gsbench::station::test
