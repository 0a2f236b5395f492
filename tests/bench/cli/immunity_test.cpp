// `gsbench immunity`: verdict and exit code, text, JSON, single cases and refused arguments.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include <profile/files.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

// Ten of each kind, without an event of a dip.
const Words kFewCases = {"immunity", "--cases", "130", "--json", "--seed", "2"};

Words with(Words arguments, const Words& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(ImmunityCommand, PassesWithoutTripsAndPrintsEachKind) {
  const json page = run_for_json(kFewCases);
  EXPECT_EQ(page["verdict"], "PASS");
  const json& kinds = page["kinds"];
  ASSERT_EQ(kinds.size(), 15U) << "13 kinds, all dips, all";
  for (std::size_t i = 0; i < 13; ++i) {
    EXPECT_EQ(kinds[i]["cases"], 10);
    EXPECT_EQ(kinds[i]["trips"], 0);
    EXPECT_EQ(kinds[i]["verdict"], "PASS");
  }
  EXPECT_EQ(kinds[0]["kind"], "dip");
  EXPECT_EQ(kinds[13]["cases"], 50);
  EXPECT_EQ(kinds[13]["events_per_1000_max"], 1);
  EXPECT_EQ(kinds[14]["cases"], 130);
}

TEST(ImmunityCommand, DoesNotDependOnThreadsButOnTheSeed) {
  const json one = run_for_json(with(kFewCases, {"--threads", "1"}));
  EXPECT_EQ(one, run_for_json(with(kFewCases, {"--threads", "3"})));
  const json other = run_for_json({"immunity", "--cases", "130", "--json", "--seed", "3"});
  EXPECT_NE(one["kinds"], other["kinds"]);
}

TEST(ImmunityCommand, KindsWithoutACaseAreNotJudged) {
  const json page = run_for_json({"immunity", "--cases", "2", "--json"});
  const json& kinds = page["kinds"];
  ASSERT_EQ(kinds.size(), 15U);
  for (const std::size_t played : {0U, 1U, 13U, 14U}) {
    EXPECT_EQ(kinds[played]["verdict"], "PASS") << kinds[played];
  }
  for (std::size_t i = 2; i < 13; ++i) {
    EXPECT_EQ(kinds[i]["cases"], 0);
    EXPECT_TRUE(kinds[i]["events_per_1000"].is_null()) << kinds[i];
    EXPECT_TRUE(kinds[i]["verdict"].is_null()) << kinds[i];
  }
  const Outcome text = run_gsbench({"immunity", "--cases", "2"});
  EXPECT_THAT(text.out, AllOf(ContainsRegex("kinds without a case: 11\n"),
                              ContainsRegex("\n  two dips .* PASS\n"),
                              ContainsRegex("\n  dip in two stages +0 +0 +– +– +0 +0 +–\n")));
}

// Noise of 3 % looks like an event now and then, also beside a dip.
TEST(ImmunityCommand, FailsWithTheFirstFailingCaseThatCanBePlayedAgain) {
  const Words noisy = {"immunity", "--cases", "390", "--noise", "3", "--json"};
  const Outcome all = run_gsbench(noisy);
  EXPECT_EQ(all.exit_code, 1) << all.err;
  const json page = json::parse(all.out);
  EXPECT_EQ(page["verdict"], "FAIL");
  EXPECT_THAT(page["reasons"].dump(), HasSubstr(" events in 150 dips"));
  EXPECT_EQ(page["kinds"][13]["verdict"], "FAIL");
  ASSERT_GE(page["sections"].size(), 2U);
  const json& failing = page["sections"][1];
  const std::string id = failing["id"];
  const std::string number = id.substr(id.find('-') + 1);
  const Outcome one = run_gsbench({"immunity", "--case", number, "--noise", "3", "--json"});
  EXPECT_EQ(one.exit_code, 1) << one.err;
  EXPECT_EQ(json::parse(one.out)["sections"][0], failing);
  EXPECT_EQ(failing["paragraphs"][0], "[signal]");
}

TEST(ImmunityCommand, WritesACaseAsAProfile) {
  const TemporaryFolder folder;
  for (const char* number : {"3", "8", "11"}) {
    const std::string profile = folder.file("case.toml");
    const Outcome written = run_gsbench({"immunity", "--case", number, "--profile", profile});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(run_gsbench({"check", profile}).exit_code, 0) << text_of(profile);
  }
  const Outcome printed = run_gsbench({"immunity", "--case", "11", "--profile", "-"});
  EXPECT_EQ(printed.out, text_of(folder.file("case.toml")));
}

// The folder's name needs escapes.
TEST(ImmunityCommand, WritesAProfileOfAGridOfTheUsersForAnyFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path grids = folder.path() / R"(my "grids" \ here)";
  const std::filesystem::path cases = folder.path() / "cases";
  std::filesystem::create_directories(grids);
  std::filesystem::create_directories(cases);
  std::ofstream(grids / "own.toml") << text_of(profile::find_grid("ieee24", "").value().path);
  const auto in_folder_of_grids = [&] { std::filesystem::current_path(grids); };
  const std::string profile = (cases / "case.toml").string();
  const Outcome written = run_gsbench(
      {"immunity", "./own.toml", "--case", "3", "--profile", profile}, in_folder_of_grids);
  EXPECT_EQ(written.exit_code, 0) << written.err;
  const Outcome checked = run_gsbench({"check", profile});
  EXPECT_EQ(checked.exit_code, 0) << checked.err << text_of(profile);
  EXPECT_THAT(text_of(profile), HasSubstr(R"(my \"grids\" \\ here/own.toml")"));
  const std::string grid = (grids / "own.toml").string();
  expect_refused({"immunity", grid, "--case", "3", "--profile", grid}, "as it is the input");
}

TEST(ImmunityCommand, NoLineIsWiderThan100Columns) {
  expect_lines_within_100_columns({"immunity", "--cases", "13"});
  for (const char* number : {"7", "9", "10", "12"}) {
    expect_lines_within_100_columns({"immunity", "--case", number});
  }
  expect_lines_within_100_columns({"immunity", "--help"});
}

TEST(ImmunityCommand, InterruptedReportsTheCasesSoFar) {
  const json page = json::parse(interrupted({"immunity", "--json"}, 200).out);
  EXPECT_TRUE(page["verdict"].is_null());
  EXPECT_THAT(page["reasons"].dump(), HasSubstr(" of 100000 cases"));
  EXPECT_GT(page["kinds"][14]["cases"], 0);
  EXPECT_LT(page["kinds"][14]["cases"], 100000);
}

TEST(ImmunityCommand, RefusesBadArguments) {
  expect_refused({"immunity", "--cases", "0"}, "--cases");
  expect_refused({"immunity", "--cases", "10000001"}, "--cases");
  expect_refused({"immunity", "--noise", "10.1"}, "--noise: 10.1 is not a number from 0 to 10");
  for (const char* const mw : {"-1", "1054", "1e9", "nan"}) {
    expect_refused({"immunity", "--cases", "1", "--accumulated", mw},
                   "is not within 0 … 1053.63 MW");
  }
  expect_refused({"immunity", "--case", "1", "--profile", "-", "--accumulated", "1e9"},
                 "P^A of 1e+09 MW is not within 0 … 1053.63 MW, the range in grid ieee24");
  expect_refused({"immunity", "--profile", "case.toml"}, "--case");
  expect_refused({"immunity", "--case", "1", "--cases", "10"}, "--cases excludes --case");
  for (const Words& more : {Words{"--json"}, {"-o", "-"}}) {
    expect_refused(with({"immunity", "--case", "1", "--profile", "-"}, more), "--profile excludes");
  }
  expect_refused({"immunity", "no-such-grid"}, "no-such-grid");
}

}  // namespace
}  // namespace gsbench::test
