// The other reports of runs with many outlets.
#include "many_outlets.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <render/layout.hpp>
#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using record::Verdict;
using sample::count;
using sample::has;
using sample::many_outlets;
using sample::miss_a_limit;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    all.push_back(line);
  }
  return all;
}

TEST(LargeTerminal, CountsMoreThan32OutletsByGroupAndVerdict) {
  RunRecord run = many_outlets(33);
  miss_a_limit(run.outlets[7]);
  miss_a_limit(run.outlets[9]);
  run.outlets[4].verdict = Verdict::kError;
  const auto all = lines_of(terminal(run));
  EXPECT_THAT(all, Contains("group  outlets  PASS  FAIL  ERROR"));
  EXPECT_THAT(all, Contains("odd         16    14     2      0"));
  EXPECT_THAT(all, Contains("even        17    16     0      1"));
  EXPECT_THAT(all, Contains("all         33    30     2      1"));
  EXPECT_THAT(all,
              Contains("6 of the 33 outlets, the worst first; `gsbench report RUN --outlet ID` "
                       "shows others:"));
  const auto rows = std::count_if(all.begin(), all.end(),
                                  [](const auto& line) { return line.rfind("outlet-", 0) == 0; });
  EXPECT_EQ(rows, 6);
  EXPECT_THAT(all, Contains(StartsWith("outlet-4 ")));
  EXPECT_THAT(all, Contains(StartsWith("FAIL outlet-9 event.delay: ")));
}

TEST(LargeTerminal, HasARowForEachOf32Outlets) {
  const auto all = lines_of(terminal(many_outlets(32)));
  EXPECT_EQ(all.size(), 36U);  // the run, two lines of headings, the outlets, the verdict
  EXPECT_THAT(all, Not(Contains(StartsWith("group "))));
}

TEST(LargeTerminal, ShowsTheNamedOutlets) {
  RunRecord run = many_outlets(1000);
  miss_a_limit(run.outlets[3]);
  run.verdict = Verdict::kFail;
  View view = run;
  view.outlets = {500, 2};
  const auto all = lines_of(terminal(view));
  ASSERT_EQ(all.size(), 6U);
  EXPECT_THAT(all[3], StartsWith("outlet-500 "));
  EXPECT_THAT(all[4], StartsWith("outlet-2 "));
  EXPECT_EQ(all[5], "FAIL: 1 of 10000 judged measurements on 1000 outlets did not pass.");
}

// `gsbench run` prints an empty line and the path of the report below it.
TEST(LargeTerminal, Takes38LinesWithMuchOfEverything) {
  RunRecord run = many_outlets(1000);
  const std::string words = "many words of a long text ";
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += words;
  }
  run.profile_title = run.verdict_reason = text;
  run.interrupted = true;
  run.source = {text, text, text};
  run.clocks.resize(100, {text, text, 1.0});
  run.recording = {text, text, text, text, text, 1.0, true};
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    record::OutletRecord& outlet = run.outlets[i];
    outlet.fault = text;
    outlet.group = std::to_string(i % 50) + text;
    outlet.id += text;
    outlet.reports.marks.push_back({0, "decision.trust", 0.0, ""});
    for (record::MeasurementResult& result : outlet.measurements) {
      result.judged = true;
      result.verdict = Verdict::kFail;
      result.reason = text;
    }
    outlet.verdict = static_cast<Verdict>(i % 4);
  }
  for (const std::string& shown : {terminal(run), coloured_terminal(run)}) {
    EXPECT_EQ(lines_of(shown).size(), 38U) << shown;
    EXPECT_EQ(count(shown, "Kept of outlet-"), 6U);
    EXPECT_THAT(shown, HasSubstr("… and 997 more outlets"));
    EXPECT_THAT(lines_of(shown), Contains(MatchesRegex("… and 139[89][0-9] more")));
  }
}

// Three outlets miss two limits; the other 997 miss one of another measure.
TEST(LargeTerminal, NamesOneShortfallOfEachMeasureThenThoseOfTheWorstOutletsInTheFreeLines) {
  RunRecord run = many_outlets(1000);
  for (record::OutletRecord& outlet : run.outlets) {
    miss_a_limit(outlet);
  }
  for (const std::size_t bad : {500U, 501U, 502U}) {
    sample::measurement(run.outlets[bad], "ekf.error").verdict = Verdict::kFail;
  }
  const auto all = lines_of(terminal(run));
  EXPECT_EQ(all.size(), 38U);
  std::vector<std::string> named;
  for (const std::string& line : all) {
    if (line.rfind("FAIL outlet-", 0) == 0) {
      named.push_back(line.substr(5, line.find(':') - 5));
    }
  }
  ASSERT_GT(named.size(), 15U);
  named.resize(7);
  EXPECT_THAT(
      named, ElementsAre("outlet-500 event.delay", "outlet-500 ekf.error", "outlet-501 event.delay",
                         "outlet-501 ekf.error", "outlet-502 event.delay", "outlet-502 ekf.error",
                         "outlet-0 event.delay"));
}

TEST(LargeTerminal, ShortensALongIdAndTheTextButNotTheMeasure) {
  RunRecord run = many_outlets(40);
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    miss_a_limit(run.outlets[i]);
    run.outlets[i].id = std::string(60, 'n') + std::to_string(i);
    sample::measurement(run.outlets[i], "event.delay").reason = std::string(100, 'r');
  }
  const auto all = lines_of(terminal(run));
  EXPECT_THAT(all, Contains(MatchesRegex("FAIL n+…n+0 event[.]delay: .* ms, limit ≤ 160 .*r…")));
  for (const std::string& line : all) {
    EXPECT_LE(columns_of(line), kLineColumns) << line;
  }
}

TEST(LargeTerminal, CountsByVerdictOnlyIfThereAreMoreThanFiveGroups) {
  RunRecord run = many_outlets(40);
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    run.outlets[i].group = "group-" + std::to_string(i % 5);
  }
  EXPECT_THAT(lines_of(terminal(run)), Contains(StartsWith("group-4 ")));
  run.outlets[7].group = "group-5";
  miss_a_limit(run.outlets[9]);
  const auto all = lines_of(terminal(run));
  EXPECT_THAT(all, Not(Contains(StartsWith("group-"))));
  EXPECT_THAT(all, Contains("all 6       40    39     1"));
}

TEST(LargeCsv, IsWrittenInPartsOfOneOutletAtMost) {
  const RunRecord run = many_outlets(3);
  std::string text;
  std::size_t largest = 0;
  write_csv(run, [&](std::string_view part) {
    text += part;
    largest = std::max(largest, part.size());
  });
  EXPECT_TRUE(text == csv(run));
  EXPECT_LT(largest, 70'000U);
  View view = run;
  view.outlets = {1};
  EXPECT_EQ(count(csv(view), "\noutlet-1,"), run.outlets[1].reports.trace.tick.size());
  EXPECT_THAT(csv(view), Not(HasSubstr("outlet-0")));
}

TEST(LargeRuns, JsonAndJUnitHaveTheNamedOutletsOnly) {
  RunRecord run = many_outlets(5);
  miss_a_limit(run.outlets[4]);
  run.verdict = Verdict::kFail;
  View view = run;
  view.outlets = {3};
  const auto whole = nlohmann::json::parse(json(view));
  EXPECT_EQ(whole["verdict"], "FAIL");
  ASSERT_EQ(whole["outlets"].size(), 1U);
  EXPECT_EQ(whole["outlets"][0]["id"], "outlet-3");
  EXPECT_EQ(count(junit_xml(view), "<testsuite "), 1U);
  EXPECT_THAT(junit_xml(view), Not(HasSubstr("<failure")));
  EXPECT_EQ(count(junit_xml(run), "<failure"), 1U);
}

}  // namespace
}  // namespace gsbench::render
