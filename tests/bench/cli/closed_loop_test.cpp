// `gsbench fleet --closed-loop --profile`: the verdict beside clairvoyants, for one profile and for
// several.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <render/layout.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr const char* kSteady = "frequency = [[0.0, 50.0], [2.0, 50.0]]\n";
constexpr const char* kFalling = "frequency = [[1.0, 50.0], [2.0, 49.6]]\n";

class ClosedLoopProfiles : public testing::Test {
 protected:
  // A profile of 2 s; 600 MW are lost at 1 s unless it has a frequency of its own.
  std::string write(const std::string& name, double noise_pct, const std::string& frequency = "") {
    const std::string loss =
        frequency.empty() ? "[[grid.loss]]\nat_s = 1.0\npower_mw = 600.0\n" : "";
    return folder_.write(
        name + ".toml",
        fmt::format(
            "title = \"{}\"\nsource = \"Test\"\n[grid]\n"
            "system = \"ieee24\"\n{}[signal]\nduration_s = 2.0\n"
            "noise_pct = {}\n{}[[outlet]]\n[[expect]]\nmeasure = \"relay.edges\"\nmax = 0\n",
            name, loss, noise_pct, frequency));
  }
  static Words command(const Words& more) {
    Words words = {"fleet", "--closed-loop", "--duration", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  const TemporaryFolder folder_;
};

TEST_F(ClosedLoopProfiles, OneProfileHasAVerdict) {
  const Outcome passed = run_gsbench(command({"--profile", write("usual", 1.0), "--json"}));
  EXPECT_EQ(passed.exit_code, 0) << passed.err;
  EXPECT_EQ(json::parse(passed.out)["verdict"], "PASS");
  EXPECT_THAT(json::parse(passed.out)["reasons"], IsEmpty());
  // The outlets see nothing of the loss in so much noise.
  const Outcome failed = run_gsbench(command({"--profile", write("noisy", 90.0)}));
  EXPECT_EQ(failed.exit_code, 1) << failed.err;
  EXPECT_THAT(failed.out, AllOf(HasSubstr("\n  verdict: FAIL: the nadir of 49."),
                                HasSubstr("\n  clairvoyant-0.96 ")));
}

TEST_F(ClosedLoopProfiles, ARecordedFrequencyIsNotJudged) {
  const json page = run_for_json(command({"--profile", write("falling", 1.0, kFalling), "--json"}));
  EXPECT_TRUE(page["verdict"].is_null());
  EXPECT_THAT(page["reasons"].dump(), HasSubstr("recorded frequency"));
}

TEST_F(ClosedLoopProfiles, OfAFolderAreInOneTableAndFailIfOneFails) {
  write("falling", 1.0, kFalling);
  write("noisy", 90.0);
  write("steady", 1.0, kSteady);
  write("usual", 1.0);
  const Words words = command({"--profile", folder_.path().string()});
  const Outcome text = run_gsbench(words);
  EXPECT_EQ(text.exit_code, 1) << text.err;
  EXPECT_THAT(text.out, AllOf(HasSubstr("verdict: FAIL: 2 of 3 profiles pass; not judged: 1"),
                              HasSubstr("\n  noisy: FAIL: the nadir"),
                              HasSubstr("\n  falling: not judged: "), Not(HasSubstr("stopped"))));
  std::istringstream lines(text.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(render::columns_of(line), 100U) << line;
  }

  Words for_scripts = words;
  for_scripts.emplace_back("--json");
  const json page = json::parse(run_gsbench(for_scripts).out);
  EXPECT_EQ(page["verdict"], "FAIL");
  std::vector<std::string> verdicts;
  for (const json& scenario : page["scenarios"]) {
    verdicts.push_back(scenario["profile"].get<std::string>() + " " + scenario["verdict"].dump());
    EXPECT_THAT(scenario["closed_loop"], SizeIs(9));
    EXPECT_EQ(scenario["reasons"].empty(), scenario["verdict"] == "PASS");
  }
  EXPECT_THAT(verdicts,
              ElementsAre("falling null", "noisy \"FAIL\"", "steady \"PASS\"", "usual \"PASS\""));
  ASSERT_THAT(page["sections"], SizeIs(1));
  EXPECT_THAT(page["sections"][0]["tables"], SizeIs(1));
}

TEST_F(ClosedLoopProfiles, AFolderWithOneHasATableAndEachFileCountsOnce) {
  const std::string steady = write("steady", 1.0, kSteady);
  const std::string folder = folder_.path().string();
  for (const Words& profiles : {Words{"--profile", folder},
                                {"--profile", folder + "/./steady.toml", "--profile", steady},
                                {"--profile", steady, "--profile", folder}}) {
    Words words = command(profiles);
    words.emplace_back("--json");
    const json page = run_for_json(words);
    ASSERT_THAT(page["scenarios"], SizeIs(1)) << testing::PrintToString(words);
    EXPECT_EQ(page["scenarios"][0]["profile"], "steady");
  }
}

TEST_F(ClosedLoopProfiles, AFileInAFolderThatIsNoProfileIsReportedAndLeftOut) {
  write("steady", 1.0, kSteady);
  std::filesystem::create_directory(folder_.path() / "grids");
  folder_.write("grids/own.toml", "title = \"left out in silence\"\n");
  const std::string other = folder_.write("other.toml", "title = \"x\"\nname = 1\n");
  const Words words = command({"--profile", folder_.path().string(), "--json"});
  const Outcome outcome = run_gsbench(words);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(other + ":2:1: "), Not(HasSubstr("own.toml"))));
  EXPECT_THAT(json::parse(outcome.out)["scenarios"], SizeIs(1));

  std::filesystem::remove(folder_.path() / "steady.toml");
  const Outcome none = run_gsbench(words);
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr(other + ":2:1: "));
  EXPECT_EQ(none.out, "");
  std::filesystem::remove(other);
  expect_refused(words, folder_.path().string() + ": no profile is in this folder");
  expect_refused(command({"--profile", folder_.path().string(), "--profile", other}),
                 "no profile is in this folder");
}

TEST_F(ClosedLoopProfiles, MayBeNamedSeveralTimesWithAReport) {
  const std::string report = folder_.file("set.html");
  const Outcome outcome =
      run_gsbench(command({"--profile", "paper/loss-320mw", "--profile",
                           write("steady", 1.0, kSteady), "ieee24", "-o", report}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("verdict: PASS\n"));
  EXPECT_THAT(text_of(report), AllOf(HasSubstr("paper/loss-320mw"), HasSubstr(">PASS<")));
}

TEST_F(ClosedLoopProfiles, UnknownOnesAreRefusedBeforeAnyIsPlayed) {
  expect_refused(command({"--profile", "cascades", "--profile", "cascade"}),
                 "unknown profile or folder of profiles \"cascade\"");
}

}  // namespace
}  // namespace gsbench::test
