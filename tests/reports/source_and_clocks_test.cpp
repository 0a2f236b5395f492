// What reports show of the source and of the clocks.
#include "sample_run.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

record::RunRecord physical() {
  record::RunRecord run = sample::loss_500mw(1);
  run.source = {"Maker Model 1", "20 points\n2 kSa/s", "not calibrated; from a table"};
  run.bench_uncertainty = {0.61, 0.45, 0.25, 1.5, 0.12};
  run.clocks = {{"source", "time base of the run", 0.12},
                {"relay sense", "this machine's clock", 0.61},
                {"outlet-1", "voltage dips", 0.0}};
  return run;
}

// In two lines; the HTML report has the whole plan.
TEST(SourceAndClocks, AreInTheTextInShort) {
  EXPECT_THAT(terminal(physical()),
              AllOf(HasSubstr("\nSource: Maker Model 1: 20 points\n"
                              "At most 0.25 mHz, 1.5 %, 0.12 ms from the profile; not "
                              "calibrated; from a table\n"
                              "Clock of source: "),
                    Not(HasSubstr("2 kSa/s")),
                    HasSubstr("Clock of relay sense: this machine's clock, ± 0.61 ms"),
                    HasSubstr("Clock of outlet-1: voltage dips, exact")));
}

TEST(SourceAndClocks, AreInTheHtml) {
  EXPECT_THAT(html(physical()),
              AllOf(HasSubstr("Maker Model 1"), HasSubstr("20 points"), HasSubstr("2 kSa/s"),
                    HasSubstr("0.25 mHz, 1.5 %, 0.12 ms (not calibrated; from a table)"),
                    HasSubstr("id=\"clocks\""), HasSubstr("voltage dips")));
}

TEST(SourceAndClocks, AreInTheJson) {
  const auto run = nlohmann::json::parse(json(physical()));
  EXPECT_EQ(run["source"]["name"], "Maker Model 1");
  EXPECT_EQ(run["source"]["accuracy"], "not calibrated; from a table");
  EXPECT_EQ(run["source"]["frequency_mhz"], 0.25);
  EXPECT_EQ(run["source"]["voltage_pct"], 1.5);
  EXPECT_EQ(run["source"]["time_ms"], 0.12);
  ASSERT_EQ(run["clocks"].size(), 3U);
  EXPECT_EQ(run["clocks"][1]["what"], "relay sense");
  EXPECT_EQ(run["clocks"][1]["aligned_by"], "this machine's clock");
  EXPECT_EQ(run["clocks"][1]["uncertainty_ms"], 0.61);
}

TEST(SourceAndClocks, AreNotShownIfNothingWasAligned) {
  record::RunRecord run = physical();
  run.source.accuracy = "";
  EXPECT_THAT(terminal(run), AllOf(Not(HasSubstr("Clock of")), Not(HasSubstr("Source:")),
                                   Not(HasSubstr("from the profile"))));
  EXPECT_THAT(html(run), Not(HasSubstr("id=\"clocks\"")));
}

}  // namespace
}  // namespace gsbench::render
