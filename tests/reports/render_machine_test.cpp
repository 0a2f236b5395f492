// JSON, JUnit XML and CSV reports, read back with independent readers.
#include "sample_run.hpp"

#include <QString>
#include <QXmlStreamReader>
#include <cmath>
#include <cstdlib>
#include <map>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using record::Verdict;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> keys(const nlohmann::ordered_json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) {
    names.push_back(name);
  }
  return names;
}

std::map<std::string, nlohmann::ordered_json> by_name(const nlohmann::ordered_json& outlet) {
  std::map<std::string, nlohmann::ordered_json> results;
  for (const auto& result : outlet["measurements"]) {
    results[result["name"]] = result;
  }
  return results;
}

TEST(Json, HasTheDocumentedKeys) {
  const auto whole = nlohmann::ordered_json::parse(json(sample::loss_500mw(1)));
  EXPECT_THAT(
      keys(whole),
      ElementsAre("format_version", "run_id", "profile", "profile_sha256", "grid", "grid_sha256",
                  "recording", "firmware_sha256", "gsbench_version", "software", "seed", "source",
                  "clocks", "interrupted", "fault", "verdict", "verdict_reason", "outlets"));
  EXPECT_THAT(keys(whole["outlets"][0]),
              ElementsAre("id", "group", "link", "board", "instance", "firmware", "build",
                          "protocol_version", "settings_digest", "verdict", "fault", "clock",
                          "measurements", "kept"));
  EXPECT_THAT(keys(whole["outlets"][0]["measurements"][0]),
              ElementsAre("name", "value", "unit", "low", "high", "uncertainty", "judged",
                          "expected_text", "verdict", "reason"));
}

TEST(Json, HasTheIdentityOfAnOutletAndNullForWhatIsNotKnown) {
  RunRecord run = sample::loss_500mw(2);
  run.outlets[1] = {};
  const auto whole = nlohmann::json::parse(json(run));
  EXPECT_EQ(whole["format_version"], record::kFormatVersion);
  const auto& known = whole["outlets"][0];
  EXPECT_EQ(known["board"], "mps2-an386");
  EXPECT_EQ(known["instance"], 0x12345678);
  EXPECT_EQ(known["firmware"], "0.1.0");
  EXPECT_EQ(known["build"], "3f2a9c41");
  EXPECT_EQ(known["protocol_version"], 3);
  EXPECT_EQ(known["settings_digest"], "5be1a0f2");
  for (const char* key :
       {"board", "instance", "firmware", "build", "protocol_version", "settings_digest"}) {
    EXPECT_TRUE(whole["outlets"][1].at(key).is_null()) << key;
  }
  run.outlets[0].instance = 0;  // as of the first simulated outlet
  EXPECT_EQ(nlohmann::json::parse(json(run))["outlets"][0]["instance"], 0);
}

TEST(Json, HasVerdictsOfJudgedMeasurementsOnlyAndReasonsOfThoseNotPassed) {
  RunRecord run = sample::loss_500mw(1);
  run.verdict_reason = "1 of 1 outlets did not pass";
  auto& delay = sample::measurement(run.outlets[0], "event.delay");
  delay.verdict = Verdict::kFail;
  delay.reason = "outside its limits";
  const auto whole = nlohmann::ordered_json::parse(json(run));
  EXPECT_EQ(whole["verdict_reason"], run.verdict_reason);
  auto results = by_name(whole["outlets"][0]);
  EXPECT_EQ(results["lse.loss"]["judged"], false);
  EXPECT_TRUE(results["lse.loss"]["verdict"].is_null());
  EXPECT_EQ(results["event.delay"]["judged"], true);
  EXPECT_EQ(results["event.delay"]["verdict"], "FAIL");
  EXPECT_EQ(results["event.delay"]["reason"], "outside its limits");
  EXPECT_TRUE(results["event.delay"]["expected_text"].is_null());
  EXPECT_EQ(results["decision.cause"]["expected_text"], results["decision.cause"]["value"]);
}

TEST(Json, HasFaultAndClockOfAnOutlet) {
  RunRecord run = sample::loss_500mw(2);
  run.outlets[0].fault = "fell silent after its sample 4711";
  run.outlets[0].clock = {12.5, 0.4, 0.05};
  const auto outlets = nlohmann::json::parse(json(run))["outlets"];
  EXPECT_EQ(outlets[0]["fault"], "fell silent after its sample 4711");
  EXPECT_EQ(outlets[0]["clock"],
            (nlohmann::json{
                {"drift_ppm", 12.5}, {"drift_uncertainty_ppm", 0.4}, {"uncertainty_ms", 0.05}}));
  EXPECT_TRUE(outlets[1]["fault"].is_null());
}

TEST(Json, HasTheDigestsOfThePlayedRecordingAndOfTheGrid) {
  RunRecord run = sample::loss_500mw(1);
  EXPECT_TRUE(nlohmann::json::parse(json(run))["recording"].is_null());
  run.grid_sha256 = "ab12";
  run.recording = {"grid.csv", "cd34", "#1", "f", "u", 230.0, true};
  run.recording.options =
      "frequency = \"f\"\nfrom_s = \"2\"\nskip_rows = 1\nfrequency_offset_hz = 49.5\n"
      "gaps = [\"-999\", \"b\\\"d\"]\n";
  run.recording.rows = 5;
  run.recording.gaps = 2;
  run.duration_ticks = 28000;
  const auto whole = nlohmann::json::parse(json(run));
  EXPECT_EQ(whole["grid_sha256"], "ab12");
  EXPECT_EQ(whole["recording"], (nlohmann::json{{"file", "grid.csv"},
                                                {"sha256", "cd34"},
                                                {"time", 1},
                                                {"frequency", "f"},
                                                {"voltage", "u"},
                                                {"nominal_voltage", 230.0},
                                                {"replaces_profile", true},
                                                {"options",
                                                 {{"from_s", "2"},
                                                  {"skip_rows", 1},
                                                  {"frequency_offset_hz", 49.5},
                                                  {"gaps", {"-999", "b\"d"}}}},
                                                {"rows", 5},
                                                {"gaps", 2},
                                                {"played_s", 3.5}}));
}

TEST(Json, HasAllDigitsOfNumbersNullForNaNAndTexts) {
  RunRecord run = sample::loss_500mw(2);
  run.outlets[0].measurements[0].value = 0.1 + 0.2;
  const auto whole = nlohmann::ordered_json::parse(json(run));
  EXPECT_EQ(whole["seed"], 18446744073709551615U);
  EXPECT_EQ(whole["verdict"], "PASS");
  const auto& first = whole["outlets"][0]["measurements"];
  EXPECT_EQ(first[0]["value"], 0.1 + 0.2);
  EXPECT_TRUE(first[0]["low"].is_null());
  EXPECT_EQ(first[0]["high"], 60.0);
  auto second = by_name(whole["outlets"][1]);
  EXPECT_TRUE(second.at("relay.delay")["value"].is_null());
  EXPECT_EQ(second.at("relay.end")["value"], "closed");
}

TEST(Json, IsValidForAnyText) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = "\xff\"\\\n</script>";
  EXPECT_TRUE(nlohmann::json::accept(json(run)));
}

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

std::vector<Element> elements(const std::string& xml) {
  std::vector<Element> found;
  QXmlStreamReader reader(QString::fromStdString(xml));
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    Element element{reader.name().toString().toStdString(), {}};
    for (const auto& attribute : reader.attributes()) {
      element.attributes[attribute.name().toString().toStdString()] =
          attribute.value().toString().toStdString();
    }
    found.push_back(element);
  }
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
  return found;
}

std::vector<Element> named(const std::vector<Element>& all, const std::string& name) {
  std::vector<Element> found;
  for (const Element& element : all) {
    if (element.name == name) {
      found.push_back(element);
    }
  }
  return found;
}

std::vector<std::string> error_messages(const RunRecord& run) {
  std::vector<std::string> messages;
  for (const Element& error : named(elements(junit_xml(run)), "error")) {
    messages.push_back(error.attributes.at("message"));
  }
  return messages;
}

TEST(JunitXml, HasASuitePerOutletAndACasePerMeasurement) {
  const RunRecord run = sample::loss_500mw(2);
  const auto all = elements(junit_xml(run));
  const auto suites = named(all, "testsuite");
  ASSERT_EQ(suites.size(), 2U);
  EXPECT_EQ(suites[0].attributes.at("name"), "sheds-1");
  EXPECT_EQ(suites[0].attributes.at("tests"), "14");
  EXPECT_EQ(suites[0].attributes.at("failures"), "0");
  EXPECT_EQ(suites[0].attributes.at("errors"), "0");
  EXPECT_EQ(suites[0].attributes.at("skipped"), "4");  // those for information
  const auto cases = named(all, "testcase");
  ASSERT_EQ(cases.size(), 28U);
  EXPECT_EQ(cases[3].attributes.at("name"), "event.delay");
  EXPECT_EQ(cases[3].attributes.at("classname"), "paper/loss-500mw.sheds-1");
}

TEST(JunitXml, NamesEachCaseOnceIfAMeasureHasSeveralLimits) {
  RunRecord run = sample::loss_500mw(1);
  auto& measurements = run.outlets[0].measurements;
  const record::MeasurementResult delay = sample::measurement(run.outlets[0], "event.delay");
  const record::MeasurementResult relay = sample::measurement(run.outlets[0], "relay.end");
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  measurements.assign(6, delay);
  measurements[1].low = 0.05;
  measurements[1].high = kNone;
  measurements[1].unit = "s";
  measurements[2].high = 160.00001;  // the same in six digits
  measurements[4].judged = false;
  measurements[5] = relay;
  std::vector<std::string> names;
  for (const Element& one : named(elements(junit_xml(run)), "testcase")) {
    names.push_back(one.attributes.at("name"));
  }
  EXPECT_THAT(
      names, ElementsAre("event.delay ≤ 160 ms", "event.delay ≥ 0.05 s", "event.delay ≤ 160 ms (2)",
                         "event.delay ≤ 160 ms (3)", "event.delay", "relay.end"));
}

TEST(JunitXml, HasFailuresAndErrorsForWhatDidNotPass) {
  RunRecord run = sample::loss_500mw(1);
  auto& delay = sample::measurement(run.outlets[0], "event.delay");
  delay.value = 176.0;
  delay.verdict = Verdict::kFail;
  delay.reason = "later than allowed";
  sample::measurement(run.outlets[0], "ekf.error").verdict = Verdict::kInconclusive;
  sample::measurement(run.outlets[0], "relay.end").verdict = Verdict::kError;
  run.outlets[0].verdict = run.verdict = Verdict::kError;
  const auto all = elements(junit_xml(run));
  const auto suites = named(all, "testsuite");
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_EQ(suites[0].attributes.at("failures"), "2");
  EXPECT_EQ(suites[0].attributes.at("errors"), "1");
  const auto failures = named(all, "failure");
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(failures[0].attributes.at("type"), "FAIL");
  EXPECT_EQ(failures[0].attributes.at("message"),
            "176.00 ± 0.13 ms, limit ≤ 160 ms: later than allowed");
  EXPECT_EQ(failures[1].attributes.at("type"), "INCONCLUSIVE");
  EXPECT_EQ(named(all, "error").size(), 1U);
}

TEST(JunitXml, HasAnErrorIfTheRunOrAnOutletAsAWholeDidNotPass) {
  RunRecord lost = sample::loss_500mw(2);
  lost.outlets[1].verdict = lost.verdict = Verdict::kError;
  EXPECT_THAT(error_messages(lost), ElementsAre("the outlet as a whole"));
  lost.outlets[1].fault = "fell silent after its sample 4711";
  EXPECT_THAT(error_messages(lost), ElementsAre("it fell silent after its sample 4711"));

  RunRecord unfinished;
  unfinished.verdict = Verdict::kError;
  unfinished.verdict_reason = "the run did not finish";
  EXPECT_THAT(error_messages(unfinished), ElementsAre("the run did not finish"));

  RunRecord interrupted = lost;
  interrupted.interrupted = true;
  interrupted.verdict_reason = "interrupted before its end";
  EXPECT_THAT(error_messages(interrupted),
              ElementsAre(StartsWith("it fell silent after its sample 4711; not judged; kept: "),
                          "interrupted before its end"));
}

TEST(JunitXml, IsWellFormedForAnyText) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = "<&\"'\x01\x1b[31m\xff\xef\xbf\xbf]]>";
  const auto suites = named(elements(junit_xml(run)), "testsuite");
  ASSERT_EQ(suites.size(), 1U);
  EXPECT_THAT(suites[0].attributes.at("name"), HasSubstr("<&\"'"));
}

std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char character = text[i];
    if (quoted && character == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += '"';
      ++i;
    } else if (character == '"') {
      quoted = !quoted;
    } else if (!quoted && character == ',') {
      rows.back().emplace_back();
    } else if (!quoted && character == '\n') {
      rows.emplace_back(1);
    } else {
      rows.back().back() += character;
    }
  }
  rows.pop_back();  // after the last line end
  return rows;
}

TEST(Csv, HasARowPerReportWithReferenceAndEstimate) {
  const RunRecord run = sample::loss_500mw(2);
  const auto rows = csv_rows(csv(run));
  EXPECT_THAT(rows[0], ElementsAre("outlet", "t_s", "true_frequency_hz", "frequency_hz",
                                   "rocof_hz_s", "voltage_pu", "validity", "loss_mw",
                                   "loss_sigma_mw", "trusted", "t_x_s"));
  const auto& trace = run.outlets[1].reports.trace;
  const auto& estimates = run.outlets[1].reports.estimates;
  ASSERT_EQ(rows.size(), 1 + 2 * trace.tick.size());
  std::size_t estimate = 0;
  for (std::size_t i = 0; i < trace.tick.size(); ++i) {
    const auto& row = rows[1 + trace.tick.size() + i];
    ASSERT_EQ(row.size(), 11U);
    EXPECT_EQ(row[0], "stays-2");
    EXPECT_EQ(std::stod(row[1]), static_cast<double>(trace.tick[i]) / 8000.0);
    if (std::isnan(trace.frequency_hz[i])) {
      EXPECT_EQ(row[3], "");
    } else {
      EXPECT_EQ(std::strtof(row[3].c_str(), nullptr), trace.frequency_hz[i]);  // to the bit
    }
    EXPECT_EQ(row[6], trace.validity[i] == 1 ? "valid" : "invalid");
    if (estimate < estimates.tick.size() && estimates.tick[estimate] == trace.tick[i]) {
      EXPECT_EQ(std::strtof(row[7].c_str(), nullptr), estimates.loss_mw[estimate]);
      EXPECT_EQ(row[9], estimates.trusted[estimate] != 0 ? "1" : "0");
      ++estimate;
    } else {
      EXPECT_EQ(row[7] + row[8] + row[9] + row[10], "");
    }
  }
  EXPECT_EQ(estimate, estimates.tick.size());
}

TEST(Csv, InterpolatesTheReferenceLinearly) {
  RunRecord run;
  run.sample_rate_hz = 1000;
  run.reference = {{100, 200, 400}, {50.0, 49.0, 49.5}, {0.0, 0.0, 0.0}};
  run.outlets.emplace_back();
  run.outlets[0].id = "one";
  for (const std::int64_t tick : {50, 100, 150, 200, 300, 400, 450}) {
    sample::add_report(run.outlets[0].reports.trace, tick, 50.0, 0.0, 1.0, true);
  }
  std::vector<std::string> reference;
  for (const auto& row : csv_rows(csv(run))) {
    reference.push_back(row[2]);
  }
  EXPECT_THAT(reference,
              ElementsAre("true_frequency_hz", "", "50", "49.5", "49", "49.25", "49.5", ""));
}

TEST(Csv, HasARowForAnEstimateBetweenReports) {
  RunRecord run = sample::loss_500mw(1);
  auto& outlet = run.outlets[0];
  outlet.reports.estimates.tick[3] += 1;
  const auto rows = csv_rows(csv(run));
  ASSERT_EQ(rows.size(), 2 + outlet.reports.trace.tick.size());
  int alone = 0;
  for (const auto& row : rows) {
    alone += row[3].empty() && !row[7].empty() ? 1 : 0;
  }
  EXPECT_EQ(alone, 1);
}

TEST(Csv, QuotesIdsWithSpecialCharacters) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = "a \"b\", c\nd";
  for (const auto& row : csv_rows(csv(run))) {
    ASSERT_EQ(row.size(), 11U);
  }
  EXPECT_EQ(csv_rows(csv(run))[1][0], run.outlets[0].id);
}

}  // namespace
}  // namespace gsbench::render
