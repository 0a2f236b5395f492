// Bad input of every kind: exit code 2, a message that says what and where, nothing written.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using gsbench::test::TemporaryFolder;

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

struct BadProfile {
  const char* name;
  const char* replace;  // in kGood
  const char* with;
  const char* place;  // line and column in the message
  const char* says;
};

class BadProfileTest : public testing::TestWithParam<BadProfile> {};

TEST_P(BadProfileTest, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const BadProfile& bad = GetParam();
  std::string text = kGood;
  const std::size_t at = text.find(bad.replace);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(bad.replace).size(), bad.with);
  const TemporaryFolder profile_folder;
  const std::string path = profile_folder.write("bad.toml", text);
  const TemporaryFolder output;

  const Outcome outcome = run_gsbench({"run", path, "--out", (output.path() / "runs").string()});

  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find(path + ":" + bad.place), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(bad.says), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(output.entries().empty());
}

INSTANTIATE_TEST_SUITE_P(
    EveryKind, BadProfileTest,
    testing::Values(
        BadProfile{"MalformedToml", "[signal]", "[signal", "5:", "pars"},
        BadProfile{"UnknownKey", "noise_pct", "noise_percent", "8:1", "noise_pct"},
        BadProfile{"WrongUnit", "max = 0", "unit = \"ms\"\nmax = 0", "13:", "unit"},
        BadProfile{"UnitInAString", "0.5", "\"0.5 s\"", "6:", "number"},
        BadProfile{"MissingGrid", "ieee24", "ieee25", "4:", "ieee25"},
        BadProfile{"NegativeDuration", "0.5", "-0.5", "6:", "duration_s"},
        BadProfile{"NotANumber", "noise_pct = 1.0", "noise_pct = nan", "8:", "noise_pct"},
        BadProfile{"SampleRateWithout16Milliseconds", "8000", "8001", "7:", "16 ms"},
        BadProfile{"UnknownMeasure", "event.false", "event.fals", "12:", "event.false"}),
    [](const auto& each) { return each.param.name; });

TEST(BadInput, AGoodProfileOfThatFormRuns) {
  const TemporaryFolder folder;
  const std::string path = folder.write("good.toml", kGood);
  const Outcome outcome = run_gsbench({"run", path, "--out", (folder.path() / "runs").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
}

TEST(BadInput, AGridThatMakesNoSenseIsRefusedAtItsLine) {
  const TemporaryFolder folder;
  folder.write(
      "grid.toml",
      "title = \"g\"\nsource = \"s\"\n[system]\nnominal_hz = 50\nthreshold_hz = 51\nbase_mw = 100\n"
      "load_mw = 100\ndamping_pu = 1\ngain_km = 0.95\nreheat_fraction = 0.3\n"
      "reheat_s = 8\ncondition_row_hz = 0.05\n[[plant]]\nid = \"p\"\nrating_mw = 100\n"
      "inertia_s = 5\ndroop_pu = 0.05\n");
  const std::string path = (folder.path() / "grid.toml").string();
  const Outcome outcome = run_gsbench({"params", path});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(path + ":5:"), std::string::npos) << outcome.err;
}

TEST(BadInput, AProfileThatDoesNotExistIsNamed) {
  const Outcome outcome = run_gsbench({"run", "paper/loss-501mw"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("paper/loss-501mw"), std::string::npos) << outcome.err;
}

TEST(BadInput, AnUnwritableOutputFolderIsNamed) {
  // Whoever runs it, no folder can be made in a file or in /proc.
  for (const std::string folder : {"/dev/null/runs", "/proc/runs"}) {
    const Outcome outcome = run_gsbench({"run", "paper/loss-500mw", "--out", folder});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(folder), std::string::npos) << outcome.err;
  }
}

TEST(BadInput, ARecordingThatDoesNotExistIsNamed) {
  const Outcome outcome = run_gsbench({"run", "regression/backup", "--trace", "no-such.csv",
                                       "--trace-time", "t", "--trace-frequency", "f"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("no-such.csv"), std::string::npos) << outcome.err;
}

TEST(BadInput, ARecordingThatNoGridCouldHaveMadeIsRefused) {
  const TemporaryFolder folder;
  for (const std::string rows : {"0,50\n1,1e308\n", "0,50\n1,20\n", "0,50\n1e9,50\n"}) {
    const std::string path = folder.write("recording.csv", "t,f\n" + rows);
    const Outcome outcome = run_gsbench({"run", "regression/backup", "--trace", path,
                                         "--trace-time", "t", "--trace-frequency", "f"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
  }
}

TEST(BadInput, ADeviceIsNoPlaceForAReport) {
  const Outcome outcome = run_gsbench({"waveform", "regression/command", "-o", "/dev/null"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("/dev/null"), std::string::npos) << outcome.err;
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(BadInput, UsageMistakesExitWithTwo) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
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
           {"report", "no-such-run"}}) {
    const Outcome outcome = run_gsbench(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("gsbench: ", 0), 0) << outcome.err;
  }
}

TEST(BadInput, AnUnknownCommandIsNamed) {
  const Outcome outcome = run_gsbench({"frobnicate", "ieee24"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("frobnicate is no command"), std::string::npos) << outcome.err;
}

TEST(BadInput, AFolderThatCannotBeMadeLeavesNoneAboveIt) {
  const TemporaryFolder folder;
  folder.write("file", "");
  const Outcome outcome =
      run_gsbench({"run", "paper/loss-500mw", "--out", folder.file("a/b/../../file/runs")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"file"});
}

TEST(BadInput, OutputThatIsTheInputIsRefusedAndUntouched) {
  const TemporaryFolder folder;
  const std::string profile = folder.write("my.toml", kGood);
  const std::string other_name = folder.file("link.csv");
  std::filesystem::create_hard_link(profile, other_name);
  for (const std::string& output : {profile, other_name}) {
    const Outcome outcome = run_gsbench({"waveform", profile, "-o", output});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find(output), std::string::npos) << outcome.err;
    EXPECT_EQ(gsbench::test::text_of(profile), kGood);
  }
  const std::filesystem::path runs = folder.path() / "runs";
  ASSERT_EQ(run_gsbench({"run", profile, "--out", runs.string()}).exit_code, 0);
  const std::string run = gsbench::test::only_run(runs).string();
  const Outcome outcome = run_gsbench({"report", run, "-o", run + "/record.sqlite"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(run_gsbench({"report", run}).exit_code, 0) << "the record is still there";
}

TEST(BadInput, CheckGoesThroughAllAndTellsOfEach) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.toml", "title = ");
  const Outcome outcome = run_gsbench({"check", bad, "paper/loss-500mw", "no-such"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(bad + ":1:"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("no-such"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("paper/loss-500mw: outlets: 8"), std::string::npos) << outcome.out;
  EXPECT_EQ(run_gsbench({"check", "paper/loss-500mw", "regression/backup"}).exit_code, 0);
}

TEST(BadInput, RunsOfAMissingFolderAreRefused) {
  const TemporaryFolder folder;
  const Outcome outcome = run_gsbench({"runs", "--out", folder.file("none")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find(folder.file("none")), std::string::npos) << outcome.err;
}

}  // namespace
