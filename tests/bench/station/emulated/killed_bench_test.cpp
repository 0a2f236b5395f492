// A gsbench killed during a run leaves no process behind. The next gsbench removes its files.
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include <emulation/child.hpp>
#include <emulation/hardware.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::emulation::Child;
using gsbench::test::runs;
using gsbench::test::until;
using testing::HasSubstr;

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::replace(text.begin(), text.end(), '\0', ' ');
  return text;
}

// Child processes with their command lines.
std::map<pid_t, std::string> children_of(pid_t parent) {
  std::map<pid_t, std::string> children;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (!std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
      continue;
    }
    const std::string stat = content("/proc/" + name + "/stat");
    const std::size_t name_end = stat.rfind(')');
    // ") S 1234 …": the state and the parent.
    if (name_end != std::string::npos && std::stoi(stat.substr(name_end + 4)) == parent) {
      children[std::stoi(name)] = content("/proc/" + name + "/cmdline");
    }
  }
  return children;
}

std::size_t count_of(const std::map<pid_t, std::string>& processes, const std::string& what) {
  return static_cast<std::size_t>(std::count_if(
      processes.begin(), processes.end(),
      [&](const auto& process) { return process.second.find(what) != std::string::npos; }));
}

TEST(KilledBench, LeavesNoProcessesAndTheNextRemovesItsFiles) {
  const gsbench::test::TemporaryFolder folder;
  const std::string station =
      folder.write("station.toml",
                   "title = \"Three\"\nkind = \"emulated\"\n"
                   "[[outlet]]\nid = \"m4\"\nboard = \"mps2-an386\"\nlink = \"serial\"\n"
                   "[[outlet]]\nid = \"host\"\nboard = \"host\"\nlink = \"serial\"\n"
                   "[[outlet]]\nid = \"radio\"\nboard = \"host\"\nlink = \"mqtt\"\n");
  const std::string profile =
      folder.write("calm.toml",
                   "title = \"Calm\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
                   "duration_s = 60.0\n[[outlet]]\ncount = 3\n"
                   "[[expect]]\nmeasure = \"event.count\"\nmax = 0\n");
  Child bench = gsbench::test::demand(Child::start(
      {{GSBENCH_PROGRAM, "run", profile, "--station", station, "--out", folder.file("runs")},
       folder.file("log")}));
  std::map<pid_t, std::string> children;
  ASSERT_TRUE(until([&] {
    children = children_of(bench.pid());
    return count_of(children, "qemu-system-arm") == 1 && count_of(children, "/gs-outlet ") == 2 &&
           count_of(children, "mosquitto") == 1;
  })) << content(folder.file("log"));
  const std::string& emulator =
      std::find_if(children.begin(), children.end(), [](const auto& process) {
        return process.second.find("qemu-system-arm") != std::string::npos;
      })->second;
  const std::size_t path = emulator.find("mem-path=") + 9;
  const fs::path files =
      fs::path(emulator.substr(path, emulator.find(' ', path) - path)).parent_path();
  ASSERT_THAT(files.filename().string(), HasSubstr("gsbench-emulated-"));
  ASSERT_TRUE(fs::exists(files));

  bench.kill();
  for (const auto& [pid, command] : children) {
    EXPECT_TRUE(until([pid = pid] { return !runs(pid); })) << command;
  }
  EXPECT_TRUE(fs::exists(files));
  const auto next = gsbench::test::demand(gsbench::emulation::Hardware::set_up({}));
  EXPECT_FALSE(fs::exists(files));
}

}  // namespace
