// `gsbench reproduce` and `gsbench fleet`: text, JSON, HTML and refused arguments.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <map>
#include <sstream>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

json reproduced(const std::string& only, const Words& more = {}) {
  Words arguments = {"reproduce", "--only", only, "--n", "20000", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_for_json(arguments);
}

const std::string kFirmware = "firmware, known event";
const std::string kReconciled = "experiment: reconciled parameters";

// The figure of a table's row and column, in the first table that has both.
double figure(const json& section, const std::string& row_name, const std::string& column) {
  for (const json& table : section["tables"]) {
    for (std::size_t i = 0; i < table["columns"].size(); ++i) {
      for (const json& row : table["rows"]) {
        if (table["columns"][i] == column && row["name"] == row_name) {
          return row["figures"][i];
        }
      }
    }
  }
  ADD_FAILURE() << "no " << row_name << " × " << column;
  return 0.0;
}

TEST(Reproduce, Table4IsBetterThanThePapers) {
  const json section = reproduced("table4")["sections"][0];
  EXPECT_EQ(section["id"], "table4");
  EXPECT_EQ(figure(section, "paper", "within 4 %, %"), 92.38);
  EXPECT_GE(figure(section, kFirmware, "within 4 %, %"), 99.9);
  EXPECT_EQ(figure(section, kFirmware, "beyond 10 %, %"), 0.0);
  EXPECT_GE(figure(section, "firmware, Gaussian, on a report", "within 4 %, %"), 99.0);
}

TEST(Reproduce, Table5IsBetterThanThePapers) {
  const json section = reproduced("table5")["sections"][0];
  EXPECT_GE(figure(section, kReconciled, "within 4 %, %"), 77.0);
}

TEST(Reproduce, AMillionOutletsShedTheRequiredPower) {
  const json section = reproduced("fig21")["sections"][0];
  EXPECT_NEAR(figure(section, "required", "shed, MW"), 148.08, 0.01);
  for (const std::string& row : {kFirmware, kReconciled + ", errors of 5 %"}) {
    EXPECT_NEAR(figure(section, row, "error, %"), 0.0, 0.1);
  }
  // Eq. (11) as printed, which the paper's method always has, sheds half a group too little: 0.45
  // MW.
  const json whole = reproduced("fig21", {"--accumulated", "whole"})["sections"][0];
  EXPECT_NEAR(figure(section, kFirmware, "shed, MW") - figure(whole, kFirmware, "shed, MW"), 0.45,
              0.1);
  EXPECT_EQ(figure(whole, "paper's method", "shed, MW"),
            figure(section, "paper's method", "shed, MW"));
}

TEST(Reproduce, PlaysFigure19WithOutletsThatMeasureTheVoltage) {
  const json section = reproduced("fig19", {"--seed", "3"})["sections"][0];
  EXPECT_EQ(figure(section, "paper", "LSE, MW"), 310.0);
  for (const char* outlet : {"sheds-1", "sheds-4", "stays-1", "stays-4"}) {
    EXPECT_NEAR(figure(section, outlet, "error, %"), 0.0, 4.0) << outlet;
    EXPECT_LE(figure(section, outlet, "decision, ms"), 960.0) << outlet;
  }
  const json& frequency = section["plots"][0];
  ASSERT_EQ(frequency["curves"].size(), 2U);  // reference and measured
  EXPECT_GT(frequency["x"].size(), 100U);
  for (std::size_t i = 0; i < frequency["x"].size(); ++i) {
    EXPECT_NEAR(frequency["curves"][0]["y"][i], frequency["curves"][1]["y"][i], 0.05) << i;
  }
}

TEST(Reproduce, EverySectionIsTheSameOnAnyNumberOfThreads) {
  const std::string all = "table2,table3,table4,table5,fig16,fig19,fig21,fig22";
  const json one = reproduced(all, {"--threads", "1"});
  EXPECT_EQ(one["sections"].size(), 8U);
  for (const char* threads : {"2", "3"}) {
    EXPECT_EQ(reproduced(all, {"--threads", threads}), one) << threads;
  }
}

// A choice that the paper leaves open, made by option, gives the figures that the tables of choices
// have for it.
TEST(Reproduce, OptionsGiveTheSameFiguresAsTheTablesOfVariants) {
  const json usual = reproduced("table2,table4")["sections"];
  const json chosen = reproduced(
      "table2,table4", {"--noise-distribution", "gaussian", "--loss-instant", "between-reports",
                        "--rocof-window", "8", "--count-lines", "38"})["sections"];
  const char* const within = "within 4 %, %";
  EXPECT_EQ(figure(chosen[1], kFirmware, within),
            figure(usual[1], "firmware, Gaussian, between reports", within));
  EXPECT_EQ(figure(chosen[0], "320 MW, σ = 0.01 Hz", "paper's method"),
            figure(usual[0], "slope over 8 samples, 38 slopes from sample 0, > 15 hits",
                   "320 MW, Gaussian"));
  const json wide_start = reproduced(
      "table4", {"--ekf-loss-sigma", "823.5", "--ekf-instant-sigma", "0.05"})["sections"][0];
  EXPECT_EQ(figure(wide_start, "paper's method", within),
            figure(usual[1], "paper's method, EKF start σ 823.5 MW and 50 ms", within));
}

TEST(Reproduce, InterruptedReportsTheSectionsSoFar) {
  for (const Words& command :
       std::vector<Words>{{"reproduce", "--only", "table4", "--n", "4000000000", "--json"},
                          {"fleet", "--sweep", "--json"},
                          {"fleet", "--closed-loop", "--profile", "cascades", "--json"}}) {
    const json page = json::parse(interrupted(command).out);
    EXPECT_FALSE(page["sections"].empty());
    EXPECT_THAT(page["facts"].dump(), HasSubstr("incomplete"));
  }
}

TEST(Fleet, InterruptedLeavesOutUnfinishedSimulationsAndReportsThat) {
  // Interrupted while the controls are simulated, or after.
  const std::string text = interrupted({"fleet", "--rules", "paper", "--sweep"}, 250).out;
  EXPECT_THAT(text, HasSubstr("stopped: "));
  EXPECT_THAT(text, HasSubstr("incomplete"));
  // An unfinished simulation would have too little load shed.
  const auto row = text.find("  Grid Sense  ");
  if (row != std::string::npos) {
    EXPECT_THAT(text.substr(row, 60), HasSubstr(" 148."));
  }
}

TEST(Reproduce, WritesAReportWithoutExternalFiles) {
  const TemporaryFolder folder;
  const std::string report = folder.file("paper.html");
  const Outcome outcome = run_gsbench({"reproduce", "--only", "fig13,table1,fig14", "-o", report});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(" 351.9 "));
  const std::string text = text_of(report);
  EXPECT_THAT(text, HasSubstr("id=\"table1\""));
  EXPECT_THAT(text, Not(HasSubstr("<script src")));
  EXPECT_THAT(text, Not(HasSubstr("<link rel=\"stylesheet\"")));
}

TEST(Reproduce, NoLineIsWiderThan100Columns) {
  expect_lines_within_100_columns({"reproduce", "--n", "2000"});
  expect_lines_within_100_columns({"reproduce", "--n", "2000", "--grid", "ieee24-by-unit", "--only",
                                   "fig13,table1,table2", "--noise-distribution", "gaussian",
                                   "--loss-instant", "between-reports"});
  expect_lines_within_100_columns({"reproduce", "--help"});
}

// With more trajectories, shares have more decimals.
TEST(Reproduce, TextHasTheDigitsThatTheTrajectoriesSupport) {
  const std::string text = run_gsbench({"reproduce", "--only", "table4,fig13", "--n", "20000"}).out;
  EXPECT_THAT(text, HasSubstr("time of its nadir, s   3.72     3.76\n"));
  EXPECT_THAT(text, HasSubstr("firmware, known event               100.0    0.000  5.0005"));
  const std::string more = run_gsbench({"reproduce", "--only", "table4", "--n", "200000"}).out;
  EXPECT_THAT(more, HasSubstr("paper                               92.38"));
}

TEST(Fleet, NoLineIsWiderThan100Columns) {
  const Words small = {"fleet", "--per-group", "2", "--least", "5000", "--most", "900000"};
  for (const Words& more : std::vector<Words>{
           {"--delay-aware", "--closed-loop", "--duration", "4"},
           {"--noise-distribution", "gaussian", "--sweep", "--losses", "450", "--delays",
            "0,0.1,0.123456", "--noises",
            "0,0.001,0.002,0.003,0.004,0.005,0.006,0.007,0.008,0.009,0.01,0.02,0.05"}}) {
    Words arguments = small;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_lines_within_100_columns(arguments);
  }
  expect_lines_within_100_columns({"fleet", "--help"});
}

// By eq. (17) the switching-off frequency of the last group is reached, so that no group stays
// fully on.
TEST(Fleet, PrintsNoneForAGroupThatDoesNotExist) {
  const Words arguments = {"fleet",   "--rules", "paper",  "--per-group", "20",
                           "--least", "500",     "--most", "90000"};
  const std::string text = run_gsbench(arguments).out;
  const auto row = text.find("switching-off frequencies alone");
  ASSERT_NE(row, std::string::npos);
  EXPECT_THAT(text.substr(row, 100), HasSubstr(" none\n"));
}

TEST(Reproduce, RejectsUnknownSectionsAndValuesOutOfRange) {
  expect_refused({"reproduce", "--only", "table9"},
                 "unknown section \"table9\"; the sections are fig13, table1");
  expect_refused({"reproduce", "--n", "0"}, "");
  expect_refused({"reproduce", "--rocof-window", "1"}, "");
  expect_refused({"reproduce", "--only", "table4", "--ekf-loss-sigma", "0"}, "");
  expect_refused({"reproduce", "--only", "table4", "--ekf-loss-sigma", "nan"}, "");
  expect_refused({"reproduce", "--only", "table2", "--hits-above", "36"}, "");
  expect_refused({"reproduce", "--noise-distribution", "pink"}, "pink not in {gaussian,uniform}");
  expect_refused({"reproduce", "--only", "fig13", "-o", "/nowhere/x.html"}, "/nowhere/x.html");
}

TEST(Fleet, ComparesGridSenseWithOtherControls) {
  const json section = run_for_json({"fleet", "--per-group", "20", "--least", "500", "--most",
                                     "90000", "--delay-aware", "--json"})["sections"][0];
  EXPECT_NEAR(figure(section, "no control", "nadir, Hz"), 49.290, 0.001);
  EXPECT_NEAR(figure(section, "Grid Sense", "shed, MW"), 159.9, 1.6);
  EXPECT_NEAR(figure(section, "switching-off frequencies alone", "shed, MW"), 142.0, 14.0);
  EXPECT_NEAR(figure(section, "central control", "first action, s"), 1.9, 1e-9);
  const json& rows = section["tables"][1]["rows"];
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_GE(rows[5]["figures"][2].get<double>(), 49.5);  // nadir with the delay-aware threshold
}

constexpr const char* kNadirNote = "the nadir is below f_s";

TEST(Fleet, StatesThatTheNadirIsBelowFsOnlyIfItIs) {
  const Words fleet = {"fleet",   "--groups",      "20",     "--per-group", "50",
                       "--least", "5000",          "--most", "900000",      "--duration",
                       "5",       "--closed-loop", "--json", "--loss"};
  for (const auto& [loss_mw, is_below] :
       std::map<std::string, bool>{{"300", false}, {"500", true}}) {
    Words arguments = fleet;
    arguments.push_back(loss_mw);
    const json section = run_for_json(arguments)["sections"][1];
    EXPECT_EQ(figure(section, "nadir, Hz", "threshold loss by eq. (15)") < 49.5, is_below);
    EXPECT_EQ(section["paragraphs"].dump().find(kNadirNote) != std::string::npos, is_below);
  }
}

TEST(Fleet, StatesThatNoThresholdLossAllowsForTheDelay) {
  const json page = run_for_json({"fleet", "--loss", "1500", "--groups", "20", "--per-group", "50",
                                  "--least", "5000", "--most", "900000", "--duration", "3",
                                  "--delay-aware", "--closed-loop", "--json"});
  for (const std::size_t section : {0U, 1U}) {
    EXPECT_THAT(page["sections"][section]["paragraphs"].dump(),
                HasSubstr("No threshold loss allows for the delay"));
  }
  EXPECT_EQ(page["sections"][0]["tables"][0]["rows"].size(), 5U);
  EXPECT_EQ(page["sections"][1]["tables"][0]["columns"].size(), 1U);
}

TEST(Fleet, StatesThatNoOutletDetectedTheLoss) {
  const json page =
      run_for_json({"fleet", "island-60hz", "--loss", "12", "--groups", "20", "--per-group", "50",
                    "--duration", "3", "--delay-aware", "--closed-loop", "--json"});
  EXPECT_THAT(page["sections"][0].dump(), HasSubstr("No outlet switched off after the loss of 12"));
  const json& section = page["sections"][1];
  EXPECT_THAT(section.dump(), HasSubstr("No outlet detected the loss of 12 MW"));
  EXPECT_EQ(section["tables"][0]["columns"].size(), 1U);
  EXPECT_EQ(figure(section, "outlets that detected the loss", "threshold loss by eq. (15)"), 0.0);
}

TEST(Fleet, ComparesControlsOfAProfileInAClosedLoop) {
  const json page = run_for_json(
      {"fleet", "--closed-loop", "--profile", "paper/loss-600mw", "--duration", "5", "--json"});
  std::vector<std::string> strategies;
  for (const json& row : page["closed_loop"]) {
    strategies.push_back(row["strategy"]);
    std::vector<std::string> keys;
    for (const auto& [key, value] : row.items()) {
      keys.push_back(key);
    }
    EXPECT_THAT(keys,
                UnorderedElementsAre("strategy", "shed_mw", "nadir_hz", "end_hz", "outlets_off",
                                     "first_action_s", "last_action_s", "false_events"));
  }
  EXPECT_THAT(strategies,
              ElementsAre("none", "paper", "gsbench", "central", "ufls", "clairvoyant-0.3",
                          "clairvoyant-0.5", "clairvoyant-0.75", "clairvoyant-0.96"));
  const json& none = page["closed_loop"][0];
  EXPECT_TRUE(none["first_action_s"].is_null());
  EXPECT_TRUE(none["outlets_off"].is_null());
  const json& gsbench = page["closed_loop"][2];
  EXPECT_GT(gsbench["nadir_hz"].get<double>(), none["nadir_hz"].get<double>() + 0.2);
  EXPECT_TRUE(gsbench["outlets_off"].is_number_integer());
  EXPECT_GT(gsbench["outlets_off"].get<int>(), 100);
  EXPECT_EQ(gsbench["false_events"].get<int>(), 0);
}

TEST(Fleet, ComparesTheControlsOfASingleLossAsWell) {
  const json page = run_for_json({"fleet", "--per-group", "1", "--least", "1e4", "--most", "1.8e6",
                                  "--loss", "600", "--duration", "5", "--closed-loop", "--json"});
  ASSERT_EQ(page["closed_loop"].size(), 9U);
  const json& clairvoyant = page["closed_loop"][5];
  EXPECT_EQ(clairvoyant["strategy"], "clairvoyant-0.3");
  EXPECT_NEAR(clairvoyant["shed_mw"].get<double>(), 249.8, 0.4);
  EXPECT_NEAR(clairvoyant["first_action_s"].get<double>(), 1.3, 0.017);
  EXPECT_NEAR(page["closed_loop"][1]["shed_mw"].get<double>(),
              figure(page["sections"][1], "shed, MW", "threshold loss by eq. (15)"), 1e-9);
}

TEST(Fleet, PlaysAProfileOnAnotherGridIfOneIsGiven) {
  const Words arguments = {"fleet", "--closed-loop", "--profile", "paper/loss-500mw", "--duration",
                           "1",     "--json"};
  Words other = arguments;
  other.emplace_back("ieee24-by-unit");
  const auto nadir_hz = [](const json& page) {
    return page["closed_loop"][0]["nadir_hz"].get<double>();
  };
  EXPECT_LT(nadir_hz(run_for_json(other)), nadir_hz(run_for_json(arguments)) - 0.01);
}

TEST(Fleet, RejectsOptionsThatAProfileReplaces) {
  expect_refused({"fleet", "--profile", "paper/loss-500mw"}, "--closed-loop");
  expect_refused({"fleet", "--closed-loop", "--profile", "paper/loss-500mw", "--loss", "400"},
                 "--loss");
  expect_refused({"fleet", "--closed-loop", "--profile", "paper/loss-500mw", "--rules", "paper"},
                 "--rules");
  expect_refused({"fleet", "--closed-loop", "--profile", "paper/nothing"}, "paper/nothing");
}

TEST(Fleet, WritesASweepAsHeatMapsForAnyGrid) {
  const TemporaryFolder folder;
  const std::string report = folder.file("sweep.html");
  const Outcome outcome =
      run_gsbench({"fleet", "island-60hz", "--loss", "12", "--groups", "50", "--per-group", "20",
                   "--most", "40000", "--duration", "5", "--sweep", "-o", report});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(text_of(report), HasSubstr("background: hsl("));
}

TEST(Fleet, SweepsOverAllLossesNoisesAndDelays) {
  const json sweep = run_for_json({"fleet", "--per-group", "20", "--least", "500", "--most",
                                   "90000", "--sweep", "--losses", "450,500", "--noises", "0,0.02",
                                   "--delays", "0,0.5,1", "--json"})["sections"][1];
  ASSERT_EQ(sweep["tables"].size(), 5U);  // nadirs for each delay, load shed, central control
  double above_hz = 50.0;
  for (std::size_t delay = 0; delay < 3; ++delay) {
    const json& nadirs = sweep["tables"][delay];
    ASSERT_EQ(nadirs["rows"].size(), 2U);
    ASSERT_EQ(nadirs["columns"].size(), 2U);
    const double nadir_hz = nadirs["rows"][1]["figures"][0];
    EXPECT_LT(nadir_hz, above_hz);  // lower for each longer delay
    above_hz = nadir_hz;
  }
  EXPECT_EQ(sweep["tables"][4]["columns"].size(), 3U);
  expect_refused({"fleet", "--noises", "0.01"}, "");  // needs --sweep
}

TEST(Fleet, RejectsASweepOutOfRangeBeforeItStarts) {
  expect_refused({"fleet", "--sweep", "--losses", "500,nan"}, "the sweep's losses");
  expect_refused({"fleet", "--sweep", "--noises", "0.01,-1"}, "the sweep's noises");
  expect_refused({"fleet", "--sweep", "--delays", "0,100"}, "the sweep's delays");
}

TEST(Fleet, RejectsValuesOutOfRange) {
  for (const auto& [option, value] :
       std::map<std::string, std::string>{{"--loss", "0"},
                                          {"--groups", "0"},
                                          {"--noise", "-1"},
                                          {"--delay", "inf"},
                                          {"--central-delay", "1e300"}}) {
    expect_refused({"fleet", option, value}, "gsbench: ");
  }
}

}  // namespace
}  // namespace gsbench::test
