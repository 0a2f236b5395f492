// The HTML report as text; tests/browser checks it in a browser.

#include "fields.hpp"
#include "sample_run.hpp"

#include <type_traits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <record/store.hpp>
#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using record::Verdict;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kAttack = "</script><script>alert(1)</script>&\"'";

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) {
    return "";
  }
  const std::size_t first = start + from.size();
  return text.substr(first, text.find(to, first) - first);
}

nlohmann::json plot_data_of(const std::string& page) {
  return nlohmann::json::parse(
      between(page, "<script type=\"application/json\" id=\"plot-data\">", "</script>"));
}

TEST(Html, ShowsVerdictReasonFactsAndEveryMeasurement) {
  RunRecord run = sample::loss_500mw(2);
  run.verdict = Verdict::kInconclusive;
  run.verdict_reason = "the bench's own clock was off";
  const std::string page = html(run);
  EXPECT_THAT(page, HasSubstr("INCONCLUSIVE</p>"));
  EXPECT_THAT(page, HasSubstr("the bench&apos;s own clock was off"));
  for (const std::string& fact : {run.run_id, run.profile_sha256, run.firmware_sha256, run.noise,
                                  std::to_string(run.seed), run.content_sha256}) {
    EXPECT_THAT(page, HasSubstr(fact));
  }
  for (const auto& outlet : run.outlets) {
    for (const auto& result : outlet.measurements) {
      EXPECT_THAT(page, HasSubstr("data-measurement=\"" + result.name + "\""));
    }
  }
  EXPECT_THAT(page, HasSubstr("with those that give its threshold"));  // a comparison's note
  EXPECT_THAT(page, HasSubstr("noise_pct = 1.0   # &lt;white&gt;"));   // the profile's text
}

TEST(Html, StatesThatARecordingWasPlayedInPlaceOfTheProfile) {
  RunRecord run = sample::loss_500mw(1);
  EXPECT_THAT(html(run), HasSubstr("The profile</h2>"));
  EXPECT_THAT(html(run), Not(HasSubstr("id=\"played\"")));
  run.grid_sha256 = "ab12";
  run.recording = {"grid.csv", "cd34", "#1", "f", "#3", 230.0, true};
  const std::string page = html(run);
  EXPECT_THAT(page, Not(HasSubstr("The profile</h2>")));
  const std::string played = between(page, "id=\"played\">", "</p>");
  for (const char* part :
       {"The recording grid.csv", "time: column 1, frequency: column f, voltage: column 3", "cd34",
        "in place of"}) {
    EXPECT_THAT(played, HasSubstr(part));
  }
  EXPECT_THAT(played, Not(HasSubstr("Played:"))) << "an older record";
  run.recording.options =
      "time = \"#1\"\nfrequency = \"f\"\nvoltage = \"#3\"\nfrom_s = \"2\"\nskip_rows = 1\n";
  run.recording.rows = 5;
  run.recording.gaps = 2;
  run.duration_ticks = 28000;
  EXPECT_THAT(between(html(run), "id=\"played\">", "</p>"),
              HasSubstr("Played: 5 rows, 2 of them gaps, 3.5 s. Read with from_s = &quot;2&quot;, "
                        "skip_rows = 1."));
  EXPECT_THAT(page, HasSubstr("<code>ab12</code>"));
  run.recording.replaces_profile = false;
  EXPECT_THAT(html(run), HasSubstr("The profile</h2>"));
  EXPECT_THAT(between(html(run), "id=\"played\">", "</p>"),
              AllOf(HasSubstr("The recording grid.csv"), HasSubstr("is its [signal.trace]")));
}

TEST(Html, ShowsTheDriftOfAnOutletsClock) {
  RunRecord run = sample::loss_500mw(1);
  EXPECT_THAT(html(run), HasSubstr("<dt>Clock</dt><dd>that of the source</dd>"));
  run.outlets[0].clock = {-12.5, 0.4, 0.05};
  EXPECT_THAT(html(run), HasSubstr("−12.50 ± 0.40 ppm fast, time stamps within ± 0.05 ms"));
}

TEST(Html, ListsAFaultyOutletUnderWhatDidNotPass) {
  RunRecord run = sample::loss_500mw(2);
  EXPECT_THAT(html(run), Not(HasSubstr("What did not pass")));
  run.outlets[1].verdict = Verdict::kError;
  run.outlets[1].fault = "fell <silent>";
  const std::string page = html(run);
  EXPECT_THAT(between(page, "What did not pass", "</ul>"),
              HasSubstr("<b>stays-2</b> it fell &lt;silent&gt;</li>"));
  EXPECT_THAT(page, HasSubstr("stays-2: it fell &lt;silent&gt;</summary>"));
}

TEST(Html, MarksAnEstimateThatTheOutletFlaggedAsUnreliable) {
  RunRecord run = sample::loss_500mw(2);
  EXPECT_THAT(html(run), Not(HasSubstr(" ?</td>")));
  run.outlets[1].reports.marks.push_back({0, "decision.trust", 0.0, "not settled"});
  const std::string page = html(run);
  EXPECT_THAT(page, HasSubstr(" ?</td>"));
  EXPECT_THAT(page, HasSubstr("reported by the outlet. ?: an estimate that the outlet flagged as "
                              "unreliable when it decided.</caption>"));
}

TEST(Html, LoadsNoOtherFile) {
  const std::string page = html(sample::loss_500mw(1));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
  EXPECT_THAT(page, Not(HasSubstr("<link rel=\"stylesheet\"")));
  EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("Permission is hereby granted"));  // the licence of Dygraphs
}

// Replaces every text of a part of a record.
template <class Part>
void attack(Part& part) {
  record::visit_fields<Part>(part, [](const char*, auto& value) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, std::string>) {
      value = kAttack;
    }
  });
}

TEST(Html, EscapesEveryTextOfTheRecord) {
  RunRecord run = sample::loss_500mw(1);
  const std::string plain = html(run);
  attack(run);
  attack(run.comparisons[0]);
  attack(run.stimulus[0]);
  attack(run.outlets[0]);
  attack(run.outlets[0].reports.marks[0]);
  run.outlets[0].settings[kAttack] = 1.0;
  for (auto& result : run.outlets[0].measurements) {
    attack(result);
    result.verdict = Verdict::kFail;
  }
  const std::string page = html(run);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  // The page has as many elements as that of a harmless record.
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count(page, "</script>"), count(plain, "</script>"));
  EXPECT_EQ(count(page, "</style>"), 1U);
  EXPECT_EQ(plot_data_of(page)["outlets"][0]["id"], kAttack);  // the data are unchanged
}

TEST(Html, AcceptsBytesThatAreNotText) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = "bad \xff\xfe\x01 id";
  const std::string page = html(run);
  EXPECT_THAT(page, HasSubstr("bad \xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd id"));
  EXPECT_NO_THROW(plot_data_of(page));
}

TEST(Html, ShowsADashForAMissingValue) {
  const RunRecord run = sample::loss_500mw(2);  // the relay of the second outlet never moves
  const std::string page = html(run);
  const std::string cell = between(page.substr(page.find("id=\"outlet-1\"")),
                                   "data-measurement=\"relay.delay\"", "</tr>");
  EXPECT_THAT(cell, HasSubstr("class=\"value\">–</td>"));
  EXPECT_THAT(page, Not(HasSubstr(">nan")));
}

TEST(Html, DrawsTheTracesOfTheRecord) {
  RunRecord run = sample::loss_500mw(1);
  record::MeasurementTrace& trace = run.outlets[0].reports.trace;
  trace.validity[200] = 0;  // invalid, whatever the frequency is
  const nlohmann::json data = plot_data_of(html(run));
  const nlohmann::json& curve = data["outlets"][0];
  ASSERT_EQ(curve["t"].size(), trace.tick.size());
  EXPECT_DOUBLE_EQ(curve["t"][100], static_cast<double>(trace.tick[100]) / 8000.0);
  // Half of the last digit, 1e-5 Hz.
  EXPECT_NEAR(curve["f"][100], static_cast<double>(trace.frequency_hz[100]), 0.5000001e-5);
  EXPECT_TRUE(curve["f"][200].is_null());
  EXPECT_TRUE(curve["f"][0].is_null());  // NaN in the record
  EXPECT_EQ(curve["e"]["t"].size(), run.outlets[0].reports.estimates.tick.size());
  EXPECT_EQ(curve["marks"].size(), run.outlets[0].reports.marks.size());
  EXPECT_EQ(data["stimulus"][0]["label"], "loss of 500 MW");
}

TEST(Html, IsThinnedToLessThanTwoMegabytesForTwoOutletsAndAnHour) {
  const std::string page = html(sample::steady(2, 3600.0));
  EXPECT_LT(page.size(), 2'000'000U);
  EXPECT_THAT(page, HasSubstr("At most 4000 of up to 225000 reports per outlet are drawn"));
  const nlohmann::json data = plot_data_of(page);
  ASSERT_EQ(data["outlets"].size(), 2U);
  for (const auto& outlet : data["outlets"]) {
    EXPECT_LE(outlet["t"].size(), 4000U);
  }
}

TEST(Html, DrawsAllReportsNearAMarkOfALongRun) {
  RunRecord run = sample::steady(1, 3600.0);
  const std::int64_t tick = 1000 * run.sample_rate_hz;
  run.outlets[0].reports.marks = {{tick, "event", 0.0, ""}};
  const nlohmann::json curve = plot_data_of(html(run))["outlets"][0];
  int near = 0;
  for (const double t : curve["t"]) {
    near += t >= 999.0 && t <= 1002.0 ? 1 : 0;
  }
  EXPECT_GE(near, 187);  // 3 s with a report every 16 ms
}

TEST(Html, DrawsTheOutletWithTheWorstVerdictFirst) {
  RunRecord run = sample::loss_500mw(4);
  EXPECT_THAT(html(run), HasSubstr("id=\"outlet-choice\" data-first=\"0\""));
  run.outlets[1].verdict = Verdict::kInconclusive;
  run.outlets[2].verdict = run.outlets[3].verdict = Verdict::kFail;
  EXPECT_THAT(html(run), HasSubstr("id=\"outlet-choice\" data-first=\"2\""));
}

TEST(Html, IsCompleteForAnEmptyRecord) {
  const std::string page = html(RunRecord{});
  EXPECT_THAT(page, HasSubstr("Nothing was judged."));
  EXPECT_THAT(page, HasSubstr("</html>"));
}

}  // namespace
}  // namespace gsbench::render
