// Bad input: exit code 2, a message with place and cause, and no files.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <array>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

constexpr const char* kGood = R"(title = "t"
source = "made for this test"
[grid]
system = "ieee24"
[signal]
duration_s = 0.5
sample_rate_hz = 8000
noise_pct = 1.0
[[outlet]]
accumulated_mw = 100.0
[[expect]]
measure = "event.false"
max = 0
)";

// Text of kGood, its replacement, and place and text of the message.
const std::array<const char*, 4> kBad[] = {
    {"[signal]", "[signal", "5:", "pars"},
    {"noise_pct", "noise_pc", "8:1", "noise_pct"},
    {"max = 0", "unit = \"ms\"\nmax = 0", "13:", "unit"},
    {"0.5", "\"0.5 s\"", "6:", "number"},
    {"ieee24", "ieee25", "4:", "ieee25"},
    {"0.5", "-0.5", "6:", "duration_s"},
    {"noise_pct = 1.0", "noise_pct = nan", "8:", "noise_pct"},
    {"8000", "8001", "7:", "16 ms"},
    {"event.false", "event.fals", "12:", "event.false"},
};

TEST(BadInput, AProfileErrorIsReportedWithItsPlaceAndNothingIsWritten) {
  for (const auto& [replaced, by, place, message] : kBad) {
    std::string text = kGood;
    text.replace(text.find(replaced), std::string(replaced).size(), by);
    const TemporaryFolder folder;
    const std::string path = folder.write("bad.toml", text);
    const Outcome outcome = run_gsbench({"run", path, "--out", folder.file("runs")});
    EXPECT_EQ(outcome.exit_code, 2) << by;
    EXPECT_THAT(outcome.err, HasSubstr(path + ":" + place));
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.entries(), Words{"bad.toml"});
  }
}

TEST(BadInput, TheProfileWithoutTheErrorsRuns) {
  const TemporaryFolder folder;
  const std::string path = folder.write("good.toml", kGood);
  const Outcome outcome = run_gsbench({"run", path, "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
}

TEST(BadInput, AGridErrorIsReportedWithItsLine) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "grid.toml",
      "title = \"g\"\nsource = \"s\"\n[system]\nnominal_hz = 50\nthreshold_hz = 51\nbase_mw = 100\n"
      "load_mw = 100\ndamping_pu = 1\n[[plant]]\nid = \"p\"\nrating_mw = 100\n"
      "inertia_s = 5\ndroop_pu = 0.05\n");
  expect_refused({"params", path}, path + ":5:");
}

TEST(BadInput, AMissingProfileIsNamed) {
  expect_refused({"run", "paper/loss-501mw"}, "paper/loss-501mw");
}

TEST(BadInput, AnUnwritableOutputFolderIsNamed) {
  // No user, not even root, can create a folder in a file or in /proc.
  for (const std::string folder : {"/dev/null/runs", "/proc/runs"}) {
    expect_refused({"run", "paper/loss-500mw", "--out", folder}, folder);
  }
}

void expect_recording_refused(const std::string& path) {
  expect_refused(
      {"run", "regression/backup", "--trace", path, "--trace-time", "t", "--trace-frequency", "f"},
      path);
}

TEST(BadInput, AMissingRecordingIsNamed) {
  expect_recording_refused("no-such.csv");
}

TEST(BadInput, AnImplausibleRecordingIsRefused) {
  const TemporaryFolder folder;
  for (const std::string rows : {"0,50\n1,1e308\n", "0,50\n1,20\n", "0,50\n1e9,50\n"}) {
    expect_recording_refused(folder.write("recording.csv", "t,f\n" + rows));
  }
}

TEST(BadInput, ADeviceIsRefusedAsOutputFile) {
  expect_refused({"waveform", "regression/command", "-o", "/dev/null"}, "/dev/null");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(BadInput, UsageErrorsExitWithTwo) {
  for (const Words& arguments : std::vector<Words>{
           {},
           {"runn"},
           {"run"},
           {"run", "paper/loss-500mw", "--sed", "3"},
           {"run", "paper/loss-500mw", "--seed", "three"},
           {"run", "paper/loss-500mw", "--seed", "-1"},
           {"run", "regression/steady", "--trace", "grid.csv"},
           {"params", "ieee24", "--row", "nan"},
           {"study", "paper/loss-500mw", "--within", "nonsense"},
           {"study", "paper/loss-500mw", "--within", "ekf.error=4abc"},
           {"study", "paper/loss-500mw", "--within", "ekf.error=-4"},
           {"study", "paper/loss-500mw", "--within", "relay.end=1"},
           {"study", "paper/loss-500mw", "--first-seed", "9007199254740992", "--seeds", "2"},
           {"run", "paper/loss-500mw", "--seed", "9007199254740993"},
           {"schema", "profiles"},
           {"report", "no-such-run"}}) {
    const Outcome outcome = run_gsbench(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("gsbench: ", 0), 0) << outcome.err;
  }
}

// As by a script whose variable is not set.
TEST(BadInput, AnEmptyValueIsRefusedAndNotTakenAsNone) {
  for (const auto& [option, words] : std::vector<std::pair<const char*, Words>>{
           {"--trace", {"run", "paper/loss-500mw", "--trace", ""}},
           {"--trace-from", {"run", "paper/loss-500mw", "--trace", "x", "--trace-from", ""}},
           {"--outlet", {"report", "20260101T000000Z-00000000", "--outlet", ""}},
           {"RUN", {"report", ""}}}) {
    expect_refused(words, std::string(option) + ": the value is empty");
  }
}

TEST(BadInput, AnUnknownCommandIsNamed) {
  expect_refused({"frobnicate", "ieee24"}, "unknown command 'frobnicate'");
}

TEST(BadInput, AFolderThatCannotBeCreatedLeavesNoParentFolders) {
  const TemporaryFolder folder;
  folder.write("file", "");
  expect_refused({"run", "paper/loss-500mw", "--out", folder.file("a/b/../../file/runs")}, "file");
  EXPECT_EQ(folder.entries(), Words{"file"});
}

TEST(BadInput, AnOutputThatIsTheInputIsRefusedAndUnchanged) {
  const TemporaryFolder folder;
  const std::string profile = folder.write("my.toml", kGood);
  const std::string other_name = folder.file("link.csv");
  std::filesystem::create_hard_link(profile, other_name);
  for (const std::string& output : {profile, other_name}) {
    expect_refused({"waveform", profile, "-o", output}, output);
    EXPECT_EQ(folder.read("my.toml"), kGood);
  }
  ASSERT_EQ(run_gsbench({"run", profile, "--out", folder.file("runs")}).exit_code, 0);
  const std::string run = only_run(folder.path() / "runs").string();
  expect_refused({"report", run, "-o", run + "/record.sqlite"}, "record.sqlite");
  EXPECT_EQ(run_gsbench({"report", run}).exit_code, 0) << "the record is still there";
}

TEST(BadInput, CheckReportsTheErrorsOfAllProfiles) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.toml", "title = ");
  const Outcome outcome = run_gsbench({"check", bad, "paper/loss-500mw", "no-such"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr(bad + ":1:"));
  EXPECT_THAT(outcome.err, HasSubstr("no-such"));
  EXPECT_THAT(outcome.out, HasSubstr("paper/loss-500mw: outlets: 8"));
  EXPECT_EQ(run_gsbench({"check", "paper/loss-500mw", "regression/backup"}).exit_code, 0);
}

TEST(BadInput, RunsOfAMissingFolderAreAnError) {
  const TemporaryFolder folder;
  expect_refused({"runs", "--out", folder.file("none")}, folder.file("none"));
}

}  // namespace
}  // namespace gsbench::test
