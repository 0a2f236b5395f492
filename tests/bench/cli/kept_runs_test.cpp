// Kept runs, as `runs` and `report` find them, and reports on standard output.
#include "gsbench_process.hpp"
#include <sys/stat.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <set>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kProfile = R"(title = "t"
source = "made for this test"
[grid]
system = "ieee24"
[signal]
duration_s = 0.2
[[outlet]]
[[expect]]
measure = "event.count"
max = 0
)";

class KeptRuns : public testing::Test {
 protected:
  fs::path run(const std::string& runs, const Words& more = {}) const {
    Words arguments = {"run", profile_, "--out", folder_.file(runs)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_gsbench(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return only_run(folder_.path() / runs);
  }

  const TemporaryFolder folder_;
  const std::string profile_ = folder_.write("my.toml", kProfile);
};

TEST_F(KeptRuns, AreListedOldestFirstWhateverTheNamesOfTheirFolders) {
  const fs::path first = run("first");
  const fs::path second = run("second");
  const std::set<std::string> ids = {first.filename().string(), second.filename().string()};
  fs::create_directory(folder_.file("all"));
  fs::rename(first, folder_.file("all/z"));
  fs::rename(second, folder_.file("all/a"));
  const json list = run_for_json({"runs", "--out", folder_.file("all"), "--json"});
  ASSERT_EQ(list.size(), 2U);
  const auto key = [](const json& entry) {
    return std::pair<std::string, std::string>(entry["started_utc"], entry["run_id"]);
  };
  EXPECT_LT(key(list[0]), key(list[1]));
  EXPECT_EQ(std::set<std::string>({list[0]["run_id"], list[1]["run_id"]}), ids);
}

TEST_F(KeptRuns, AreNotListedInHiddenFolders) {
  const fs::path kept = run("runs");
  fs::copy(kept, kept.parent_path() / ".trash", fs::copy_options::recursive);
  const Outcome list = run_gsbench({"runs", "--out", folder_.file("runs"), "--json"});
  EXPECT_EQ(json::parse(list.out).size(), 1U);
  EXPECT_EQ(list.err, "");
}

TEST_F(KeptRuns, HaveThePermissionsOfTheUsersUmask) {
  const mode_t before = umask(0027);
  const fs::path kept = run("runs");
  umask(before);
  EXPECT_EQ(fs::status(kept).permissions(), fs::perms(0750));
}

TEST_F(KeptRuns, StateWhichRecordingWasPlayedInPlaceOfTheProfile) {
  const std::string csv = folder_.write("other.csv", "t,f\n0,50\n0.3,49.9\n");
  const fs::path kept =
      run("runs", {"--trace", csv, "--trace-time", "t", "--trace-frequency", "f"});
  const json recording = json::parse(text_of(kept / "result.json"))["recording"];
  EXPECT_EQ(recording["file"], csv);
  EXPECT_EQ(recording["frequency"], "f");
  EXPECT_EQ(recording["sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(recording["replaces_profile"], true);
  const std::string page = text_of(kept / "report.html");
  EXPECT_THAT(page, Not(HasSubstr("The profile</h2>")));
  EXPECT_THAT(page, HasSubstr(recording["sha256"].get<std::string>()));
}

TEST_F(KeptRuns, AreReportedOnStandardOutputForOutputDash) {
  const fs::path kept = run("runs");
  const Outcome report = run_gsbench({"report", kept.string(), "--format", "json", "-o", "-"});
  EXPECT_EQ(report.out, text_of(kept / "result.json"));
}

TEST_F(KeptRuns, InAFolderWithoutPermissionGiveThatError) {
  if (geteuid() != 0) {
    GTEST_SKIP() << "only root can become nobody";
  }
  run("runs");
  fs::permissions(folder_.path(), fs::perms(0755));
  fs::permissions(folder_.file("runs"), fs::perms(0700));
  for (const Words& arguments :
       std::vector<Words>{{"runs", "--out", folder_.file("runs")},
                          {"report", folder_.file("runs/20260101"), "--out", folder_.file("runs")},
                          {"report", "20260101", "--out", folder_.file("runs")}}) {
    const Outcome outcome = run_gsbench(arguments, [] {
      constexpr uid_t kNobody = 65534;
      if (setgid(kNobody) != 0 || setuid(kNobody) != 0) {
        _exit(127);
      }
    });
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("ermission denied"));
  }
}

TEST(Waveform, IsTheOnlyStandardOutputForOutputDash) {
  const TemporaryFolder folder;
  const std::string profile = folder.write("my.toml", kProfile);
  const Outcome shown = run_gsbench({"waveform", profile, "-o", "-"});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  ASSERT_EQ(run_gsbench({"waveform", profile, "-o", folder.file("my.csv")}).exit_code, 0);
  EXPECT_EQ(shown.out, text_of(folder.path() / "my.csv"));
}

}  // namespace
}  // namespace gsbench::test
