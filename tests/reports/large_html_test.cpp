// HTML reports of runs with many outlets, long runs, and records with much of everything.
#include "many_outlets.hpp"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

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

constexpr std::size_t kMostBytes = 5'000'000;
const std::string kLongText(5000, '"');  // six bytes each in HTML

nlohmann::json curves_in(const std::string& page) {
  const std::string start = "<script type=\"application/json\" id=\"plot-data\">";
  const std::size_t from = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from))["outlets"];
}

std::vector<std::string> ids_drawn(const std::string& page) {
  std::vector<std::string> ids;
  for (const auto& outlet : curves_in(page)) {
    ids.push_back(outlet["id"]);
  }
  return ids;
}

TEST(LargeHtml, ShowsTwentyOutletsInFullFailingOnesFirst) {
  RunRecord run = many_outlets(40);
  miss_a_limit(run.outlets[31]);
  run.outlets[35].verdict = Verdict::kError;
  std::string page = html(run);
  std::vector<std::string> ids = ids_drawn(page);
  EXPECT_EQ(ids.size(), 20U);
  EXPECT_EQ(ids[0], "outlet-35");
  EXPECT_EQ(ids[1], "outlet-31");
  EXPECT_EQ(count(page, "<details id="), 20U);
  EXPECT_EQ(count(page, "<option value="), 20U);
  EXPECT_EQ(count(page, "<tr role=\"row\" data-outlet="), 20U);
  EXPECT_EQ(count(page, "</th><td role=\"cell\" data-label=\"Event after, ms\""), 40U);
  EXPECT_TRUE(has(page,
                  "follow for 20 of the 40 outlets, the worst first; <code>gsbench "
                  "report 20260301T101500Z-7f3a --outlet ID --format html</code>"));
  for (record::OutletRecord& outlet : run.outlets) {
    miss_a_limit(outlet);
  }
  page = html(run);
  EXPECT_EQ(ids_drawn(page).size(), 20U) << "all fail";
  EXPECT_LT(page.size(), kMostBytes);
  run.outlets.resize(20);
  page = html(run);
  EXPECT_EQ(ids_drawn(page).size(), 20U);
  EXPECT_FALSE(has(page, "id=\"not-drawn\""));
}

TEST(LargeHtml, ReadsTheReportsOfTheOutletsThatItDrawsOnceEach) {
  const RunRecord run = many_outlets(30);
  std::multiset<std::size_t> read;
  View view = run;
  view.read_reports = [&](std::size_t index, const record::TakeReports& take) {
    read.insert(index);
    take(run.outlets[index].reports);
  };
  html(view);
  EXPECT_EQ(read.size(), 20U);
  EXPECT_EQ(std::set<std::size_t>(read.begin(), read.end()).size(), 20U);
  read.clear();
  for (const char* format : {"terminal", "json", "junit"}) {
    find_format(format)->render(view);
  }
  EXPECT_TRUE(read.empty());
}

TEST(LargeHtml, ShowsTheNamedOutletsInFull) {
  RunRecord run = many_outlets(40);
  miss_a_limit(run.outlets[1]);
  View view = run;
  view.outlets = {33, 7};
  const std::string page = html(view);
  EXPECT_THAT(ids_drawn(page), ElementsAre("outlet-33", "outlet-7"));
  EXPECT_TRUE(has(page, "<dt>Outlets</dt><dd>2 of 40</dd>"));
  EXPECT_FALSE(has(page, "outlet-1<"));
}

TEST(LargeHtml, HasRowsOfTheWorstThousandOutlets) {
  RunRecord run = many_outlets(0);
  run.outlets.resize(100'000);
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    run.outlets[i].id = "outlet-" + std::to_string(i);
    run.outlets[i].verdict = i == 77'777 ? Verdict::kFail : Verdict::kInconclusive;
  }
  const std::string page = html(run);
  EXPECT_LT(page.size(), kMostBytes);
  EXPECT_EQ(count(page, "<th scope=\"row\" role=\"rowheader\">") -
                count(page, "<td role=\"cell\" data-label=\"This bench\">"),
            1000U);
  EXPECT_TRUE(has(page, "1000 of the 100000 outlets, the worst first"));
  EXPECT_LT(page.find("outlet-77777"), page.find("outlet-0<"));
}

// A view of outlets that are made when they are read.
View view_of(const RunRecord& run,
             const std::function<record::OutletRecord(std::size_t index)>& make) {
  View view = run;
  view.marked = make;
  view.read_reports = [make](std::size_t index, const record::TakeReports& take) {
    take(make(index).reports);
  };
  return view;
}

// Numbers with many digits, everywhere.
record::OutletRecord much(const record::OutletRecord& results, std::size_t reports) {
  record::OutletRecord outlet = results;
  for (std::size_t i = 0; i < reports; ++i) {
    const double odd = std::sin(static_cast<double>(i)) * 1e30;
    sample::add_report(outlet.reports.trace, static_cast<std::int64_t>(i) * 129, odd, -odd, odd,
                       true);
    outlet.reports.estimates.tick.push_back(static_cast<std::int64_t>(i) * 129);
    outlet.reports.estimates.loss_mw.push_back(static_cast<float>(odd));
    outlet.reports.estimates.loss_sigma_mw.push_back(static_cast<float>(odd));
    outlet.reports.estimates.event_tick.push_back(0);
    outlet.reports.estimates.loss_after_event_s.push_back(0.0F);
    outlet.reports.estimates.trusted.push_back(1);
  }
  for (int i = 0; i < 3000; ++i) {
    outlet.reports.marks.push_back({i * 5000, kLongText, 1e300, kLongText});
  }
  return outlet;
}

RunRecord much_of_everything() {
  RunRecord run = sample::loss_500mw(1);
  record::OutletRecord outlet = run.outlets[0];
  run.outlets.clear();
  run.profile_text = run.profile_title = run.profile = std::string(1'000'000, '"');
  run.verdict_reason = run.station = run.noise = run.grid = run.run_id = kLongText;
  run.source = {kLongText, "", kLongText};
  for (int i = 0; i < 2000; ++i) {
    run.source.how += kLongText + '\n';
  }
  run.recording = {kLongText, kLongText, kLongText, kLongText, kLongText, 1.0, true};
  run.clocks.resize(2000, {kLongText, kLongText, 1.0});
  run.comparisons.resize(2000, {kLongText, kLongText, 1e300, 1e-300, kLongText});
  run.stimulus.resize(2000, {1, kLongText, 1.0, kLongText});
  outlet.verdict = Verdict::kError;
  outlet.id = outlet.group = outlet.link = outlet.fault = outlet.board = kLongText;
  outlet.firmware = outlet.build = outlet.settings_digest = kLongText;
  record::MeasurementResult result = outlet.measurements[0];
  result.name = result.definition = result.text = result.reason = result.unit = kLongText;
  result.verdict = Verdict::kFail;
  outlet.measurements.resize(100, result);
  for (int i = 0; i < 300; ++i) {
    outlet.settings[kLongText + std::to_string(i)] = 1e300;
  }
  run.outlets.resize(25, outlet);
  outlet.measurements.resize(14);
  outlet.settings.clear();
  run.outlets.resize(1500, outlet);
  return run;
}

TEST(LargeHtml, StaysBelowFiveMegabytesWithMuchOfEverything) {
  const RunRecord run = much_of_everything();
  const View view =
      view_of(run, [&](std::size_t index) { return much(run.outlets[index], 20'000); });
  const std::string page = html(view);
  EXPECT_LT(page.size(), kMostBytes);
  EXPECT_GT(page.size(), 3'000'000U) << "parts are missing";
  EXPECT_TRUE(has(page, "</html>"));
  EXPECT_TRUE(has(page, "The beginning of 1000000 bytes; the record has all."));
  EXPECT_TRUE(has(page, "The first of 3003."));  // marks
  EXPECT_TRUE(has(page, "The first of 304 settings."));
  EXPECT_TRUE(has(page, "The first of 100; those that did not pass come first."));
  const nlohmann::json drawn = curves_in(page);
  ASSERT_EQ(drawn.size(), 20U);
  for (const auto& outlet : drawn) {
    EXPECT_GE(outlet["t"].size(), 50U);
    EXPECT_GE(outlet["e"]["t"].size(), 50U);
    EXPECT_GE(outlet["marks"].size(), 100U);
  }
}

TEST(LargeHtml, ShowsFirstWhatDidNotPassIfAnOutletHasTooManyMeasurements) {
  RunRecord run = many_outlets(1);
  record::OutletRecord& outlet = run.outlets[0];
  const record::MeasurementResult passed = outlet.measurements[0];
  outlet.measurements.resize(3000, passed);
  outlet.measurements.back().name = "the.last";
  EXPECT_FALSE(has(html(run), "the.last"));
  outlet.measurements.back().verdict = Verdict::kFail;
  EXPECT_TRUE(has(html(run), "data-measurement=\"the.last\""));
}

TEST(LargeHtml, KeepsTheExtremesOfTwentyLongCurves) {
  const RunRecord hour = sample::steady(1, 3600.0);
  RunRecord run = hour;
  run.outlets.clear();
  run.outlets.resize(20);
  const View view = view_of(run, [&](std::size_t index) {
    record::OutletRecord outlet = hour.outlets[0];
    outlet.reports.trace.frequency_hz[10'000 * (index + 1)] = 47.5F;
    outlet.reports.trace.rocof_hz_s[10'001 * (index + 1)] = -9.0F;
    return outlet;
  });
  const std::string page = html(view);
  EXPECT_LT(page.size(), kMostBytes);
  const nlohmann::json drawn = curves_in(page);
  ASSERT_EQ(drawn.size(), 20U);
  for (const auto& outlet : drawn) {
    EXPECT_GT(outlet["t"].size(), 1000U);
    EXPECT_THAT(outlet["f"], Contains(47.5));
    EXPECT_THAT(outlet["r"], Contains(-9.0));
  }
}

}  // namespace
}  // namespace gsbench::render
