// Kept runs, as `runs` and `report` find them, and reports on standard output.
#include "gsbench_process.hpp"
#include <sys/stat.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <csignal>
#include <set>

#include <gmock/gmock.h>

#include <record/run_record.hpp>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

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
  EXPECT_EQ(list[1]["state"], "finished");
  EXPECT_EQ(list[1]["format_version"], record::kFormatVersion);
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

TEST_F(KeptRuns, MayBeInFoldersWhoseNameIsNotUtf8) {
  const fs::path kept = run("r\xefuns");
  EXPECT_NE(text_of(kept / "report.html"), "");
  const fs::path copy = kept / "r\xefsult.json";
  const Outcome report =
      run_gsbench({"report", kept.string(), "--format", "json", "-o", copy.string()});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(text_of(copy), text_of(kept / "result.json"));
  EXPECT_EQ(run_for_json({"runs", "--out", kept.parent_path().string(), "--json"}).size(), 1U);
}

TEST_F(KeptRuns, AreReportedOnStandardOutputForOutputDash) {
  const fs::path kept = run("runs");
  const Outcome report = run_gsbench({"report", kept.string(), "--format", "json", "-o", "-"});
  EXPECT_EQ(report.out, text_of(kept / "result.json"));
}

TEST_F(KeptRuns, HaveTracesAsCsvOnRequest) {
  const fs::path plain = run("plain");
  EXPECT_FALSE(fs::exists(plain / "traces.csv"));
  const fs::path with_csv = run("with-csv", {"--csv"});
  const Outcome printed = run_gsbench({"report", with_csv.string(), "--format", "csv"});
  EXPECT_THAT(printed.out, StartsWith("outlet,t_s,true_frequency_hz,"));
  EXPECT_THAT(printed.out, HasSubstr("\noutlet-1,0.192,50,"));
  EXPECT_TRUE(printed.out == text_of(with_csv / "traces.csv"));
}

TEST_F(KeptRuns, AreReportedForNamedOutlets) {
  std::string text = kProfile;
  const std::string outlet = "[[outlet]]\n";
  text.replace(text.find(outlet), outlet.size(), outlet + "id = \"lamp\"\ncount = 12\n");
  folder_.write("my.toml", text);
  const std::string kept = run("runs").string();
  const json named = run_for_json({"report", kept, "--format", "json", "--outlet", "lamp-7",
                                   "--outlet", "lamp-2", "--outlet", "lamp-7"});
  ASSERT_EQ(named["outlets"].size(), 2U);
  EXPECT_EQ(named["outlets"][0]["id"], "lamp-7");
  EXPECT_EQ(named["outlets"][1]["id"], "lamp-2");
  const Outcome page = run_gsbench({"report", kept, "--format", "html", "--outlet", "lamp-3"});
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_NE(page.out.find("<dt>Outlets</dt><dd>1 of 12</dd>"), std::string::npos);
  expect_refused({"report", kept, "--outlet", "lamp-3", "--outlet", "lamp-13"},
                 "--outlet lamp-13: the run has no outlet with this id; its outlets are lamp-1,");
  expect_refused({"report", kept, "--outlet", "lamp"}, "--format json` lists them");
}

// As a killed bench leaves it; crash tests of the record are in tests/reports.
TEST_F(KeptRuns, ThatDidNotFinishAreReportedAsInterrupted) {
  const std::string profile = folder_.write(
      "long.toml", std::string(kProfile).replace(std::string(kProfile).find("0.2"), 3, "60"));
  const Started started =
      start_gsbench({"run", profile, "--real-time", "--out", folder_.file("runs")});
  const auto folder = [&] {
    std::error_code none_yet;
    const fs::directory_iterator entries(folder_.file("runs"), none_yet);
    return entries == fs::directory_iterator() ? fs::path() : entries->path();
  };
  const auto report = [&](const std::string& run) {
    return run_gsbench({"report", run, "--out", folder_.file("runs"), "--format", "json"});
  };
  ASSERT_TRUE(until([&] {
    return !folder().empty() &&
           report(folder().string()).out.find("were kept up to 1.") != std::string::npos;
  }));
  stop(started, SIGKILL);
  const std::string name = folder().filename().string();
  EXPECT_THAT(name, StartsWith(".unfinished-"));
  const Outcome whole = report(folder().string());
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  const json result = json::parse(whole.out);
  EXPECT_EQ(result["interrupted"], true);
  EXPECT_EQ(result["verdict"], "ERROR");
  EXPECT_THAT(result["verdict_reason"], HasSubstr("measurements were kept up to "));
  EXPECT_THAT(result["verdict_reason"], HasSubstr(" s of 60.000 s"));
  EXPECT_GT(result["outlets"][0]["kept"]["measurements"], 60);
  EXPECT_GT(result["outlets"][0]["kept"]["until_s"], 1.0);
  EXPECT_THAT(run_gsbench({"report", folder().string()}).out,
              HasSubstr("Kept of outlet-1: " + result["outlets"][0]["kept"]["measurements"].dump() +
                        " measurements, up"));
  const std::string id = result["run_id"];
  for (const std::string& start : {name, name.substr(0, 15), id, id.substr(0, 20)}) {
    EXPECT_EQ(report(start).out, whole.out) << start;
  }
  const json listed = run_for_json({"runs", "--out", folder_.file("runs"), "--json"});
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["run_id"], id);
  EXPECT_EQ(listed[0]["state"], "unfinished");
  EXPECT_EQ(listed[0]["profile"], result["profile"]);
  EXPECT_EQ(listed[0]["started_utc"].get<std::string>().size(), 20U);
  const Outcome list = run_gsbench({"runs", "--out", folder_.file("runs")});
  EXPECT_EQ(list.err, "");
  EXPECT_THAT(list.out, HasSubstr(id + "  unfinished  ERROR "));
  const Outcome csv = run_gsbench({"report", folder().string(), "--format", "csv"});
  EXPECT_THAT(csv.out, HasSubstr(",1.008,50,"));
}

TEST_F(KeptRuns, AreCompleteIfNobodyReadsWhatIsPrinted) {
  const Outcome outcome = run_gsbench({"run", profile_, "--out", folder_.file("runs")}, [] {
    int ends[2] = {};
    if (pipe(ends) != 0 || dup2(ends[1], STDOUT_FILENO) < 0) {
      _exit(127);
    }
    close(ends[0]);
    close(ends[1]);
  });
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("standard output cannot be written"));
  const fs::path kept = only_run(folder_.path() / "runs");
  EXPECT_THAT(kept.filename().string(), Not(StartsWith(".")));
  for (const char* file : {"report.html", "result.json", "junit.xml"}) {
    EXPECT_TRUE(fs::exists(kept / file)) << file;
  }
}

TEST_F(KeptRuns, WithoutARecordOrWithAnEmptyOneAreRefused) {
  const fs::path kept = run("runs");
  const std::string record = (kept / "record.sqlite").string();
  fs::resize_file(record, 0);
  for (const char* command : {"report", "rejudge"}) {
    expect_refused({command, kept.string()}, record + ": is empty");
    expect_refused({command, record}, record + ": is empty");
  }
  const Words runs = {"runs", "--out", folder_.file("runs"), "--json"};
  EXPECT_THAT(run_gsbench(runs).err, HasSubstr(record + ": is empty"));
  fs::remove(record);
  ASSERT_EQ(mkfifo(record.c_str(), 0600), 0);
  EXPECT_EQ(json::parse(run_gsbench(runs).out).size(), 0U) << "a pipe is no record";
  expect_refused({"report", kept.string()}, kept.string() + ": this folder holds no record.sqlite");
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
