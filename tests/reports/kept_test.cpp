// What reports have of a run that was interrupted: nothing was judged.
#include "sample_run.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Kept, IsALineOfEachOutletOnATerminal) {
  RunRecord run = sample::loss_500mw(2);
  EXPECT_THAT(terminal(run), Not(HasSubstr("Kept of")));
  run.interrupted = true;
  run.outlets[0].reports.marks = {
      {8800, "event", 49.9, ""},           {8800, "lse", 500.0, ""},
      {13600, "decision", 100.0, "loss"},  {13600, "relay.reported", 0.0, "shed"},
      {13651, "relay.sense", 0.0, "open"}, {20000, "relay.sense", 1.0, "closed"}};
  run.outlets[0].reports.trace.tick = {0, 128, 16000};
  run.outlets[1].reports.marks.clear();
  run.outlets[1].reports.trace.tick.clear();
  const std::string text = terminal(run);
  EXPECT_THAT(
      text,
      HasSubstr("Kept of sheds-1: 3 measurements, up to 2.000 s of 6.000 s; "
                "event 1.100 s; decision 1.700 s; relay reported open 1.700 s; relay sensed open "
                "1.706 s; relay sensed closed 2.500 s\n"));
  EXPECT_THAT(text, HasSubstr("Kept of stays-2: no measurement\n"));
}

TEST(Kept, NamesTheFirstTenMarks) {
  RunRecord run = sample::loss_500mw(1);
  run.interrupted = true;
  run.outlets[0].reports.marks.assign(12, {8000, "event", 0.0, ""});
  EXPECT_THAT(terminal(run), HasSubstr("; event 1.000 s; … and 2 more\n"));
  run.outlets[0].reports.marks.resize(10);
  EXPECT_THAT(terminal(run), HasSubstr("; event 1.000 s\n"));
}

TEST(Kept, IsPartOfEachOutletInJUnitXml) {
  RunRecord run = sample::loss_500mw(2);
  EXPECT_THAT(junit_xml(run), Not(HasSubstr("system-out")));
  run.interrupted = true;
  run.verdict = record::Verdict::kError;
  run.verdict_reason = "interrupted: gsbench was ended";
  for (record::OutletRecord& outlet : run.outlets) {
    outlet.measurements.clear();
    outlet.verdict = record::Verdict::kError;
  }
  run.outlets[0].reports.marks = {{8800, "event", 49.9, "frequency before it, Hz"},
                                  {9600, "lse", 500.0, "MW"},
                                  {13600, "decision", 100.0, "the nadir would be too low"},
                                  {13651, "relay.sense", 0.0, "open"}};
  run.outlets[0].reports.trace.tick = {0, 128, 16000};
  run.outlets[1].reports.marks.clear();
  run.outlets[1].reports.trace.tick.clear();
  run.outlets[1].fault = "fell silent";
  const std::string xml = junit_xml(run);
  EXPECT_THAT(xml,
              HasSubstr("message=\"not judged; kept: 3 measurements, up to 2.000 s of 6.000 s; "
                        "event 1.100 s; decision 1.700 s; relay sensed open 1.706 s\"/>"));
  EXPECT_THAT(xml, HasSubstr("<system-out>1.100 s  Event: 49.900 Hz, frequency before it\n"
                             "1.200 s  LSE: 500 MW\n"
                             "1.700 s  Decision: 100 MW, the nadir would be too low\n"
                             "1.706 s  Relay, sensed: open\n</system-out>"));
  EXPECT_THAT(xml, HasSubstr("message=\"it fell silent; not judged; kept: no measurement\"/>"));
  EXPECT_THAT(xml, HasSubstr("message=\"interrupted: gsbench was ended\"/>"));
}

TEST(Kept, IsShownAfterAFaultOfTheBenchToo) {
  RunRecord run = sample::loss_500mw(1);
  run.fault = "the source stopped";
  EXPECT_THAT(terminal(run), HasSubstr("Kept of stays-1: "));
  EXPECT_FALSE(nlohmann::json::parse(json(run))["outlets"][0]["kept"].is_null());
}

TEST(Kept, HasNoEmptyTableOfMeasurementsInHtml) {
  RunRecord run = sample::loss_500mw(1);
  EXPECT_THAT(html(run), HasSubstr("All measurements of stays-1"));
  run.interrupted = true;
  run.outlets[0].measurements.clear();
  run.outlets[0].reports.marks = {{8800, "event", 49.9, "frequency before it, Hz"},
                                  {9600, "lse", 500.0, "MW"}};
  const std::string page = html(run);
  EXPECT_THAT(page, Not(HasSubstr("All measurements of stays-1")));
  EXPECT_THAT(page, HasSubstr("Nothing was judged."));
  EXPECT_THAT(page, HasSubstr("class=\"text\">frequency before it</td>"));
  EXPECT_THAT(page, Not(HasSubstr("class=\"text\">MW</td>")));
}

TEST(Kept, IsPartOfEachOutletInJson) {
  RunRecord run = sample::loss_500mw(2);
  EXPECT_TRUE(nlohmann::json::parse(json(run))["outlets"][0]["kept"].is_null());
  run.interrupted = true;
  run.outlets[1].reports.trace = {};
  run.outlets[1].reports.marks.clear();
  const auto outlets = nlohmann::json::parse(json(run))["outlets"];
  const auto& ticks = run.outlets[0].reports.trace.tick;
  EXPECT_EQ(outlets[0]["kept"]["measurements"], ticks.size());
  EXPECT_EQ(outlets[0]["kept"]["until_s"], static_cast<double>(ticks.back()) / 8000.0);
  std::vector<std::string> kinds;
  for (const auto& mark : outlets[0]["kept"]["marks"]) {
    kinds.push_back(mark["kind"]);
  }
  EXPECT_THAT(kinds, ElementsAre("event", "decision", "relay.reported", "relay.sense"));
  EXPECT_EQ(outlets[0]["kept"]["marks"][1]["t_s"],
            static_cast<double>(run.outlets[0].reports.marks[2].tick) / 8000.0);
  EXPECT_EQ(outlets[1]["kept"],
            (nlohmann::json{
                {"measurements", 0}, {"until_s", nullptr}, {"marks", nlohmann::json::array()}}));
}

}  // namespace
}  // namespace gsbench::render
