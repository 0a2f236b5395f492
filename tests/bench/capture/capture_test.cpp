#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include <capture/capture.hpp>

namespace gsbench::capture {
namespace {

using gs::outlet::Trust;
using gs::wire::UplinkKind;
using ::testing::ElementsAre;

constexpr double kRate_hz = 8000.0;

link::Received received(const std::string& outlet, std::int64_t tick, UplinkKind kind) {
  link::Received message;
  message.id = outlet;
  message.message.sample = static_cast<std::uint64_t>(tick);
  message.message.kind = kind;
  return message;
}

link::Received measurement(const std::string& outlet, std::int64_t tick, float frequency_hz) {
  link::Received message = received(outlet, tick, UplinkKind::kMeasurement);
  message.message.measurement = {frequency_hz, -0.5F, 0.99F, gs::outlet::Validity::kHeld};
  return message;
}

link::Received event(const std::string& outlet, std::int64_t tick) {
  link::Received message = received(outlet, tick, UplinkKind::kEvent);
  message.message.event = {49.99F, 0.01F};
  return message;
}

link::Received relay_report(const std::string& outlet, std::int64_t tick, bool closed) {
  link::Received message = received(outlet, tick, UplinkKind::kRelay);
  message.message.relay = {closed, closed ? gs::outlet::Cause::kNone : gs::outlet::Cause::kLoss};
  return message;
}

link::Received estimate(std::int64_t tick, float loss_instant_s, Trust trust) {
  link::Received message = received("a", tick, UplinkKind::kEstimate);
  message.message.estimate = {500.0F, 8.0F, loss_instant_s, trust};
  return message;
}

record::Reports taken(Capture& capture, const std::string& outlet) {
  record::Reports reports = capture.take(outlet);
  record::place_on_run_time(reports, {}, 1 << 30);
  return reports;
}

std::string printed(const record::Mark& mark) {
  return std::to_string(mark.tick) + " " + mark.kind + " " +
         std::to_string(static_cast<int>(mark.value)) + " " + mark.text;
}

std::vector<std::string> printed(const record::Reports& reports) {
  std::vector<std::string> all;
  for (const record::Mark& mark : reports.marks) {
    all.push_back(printed(mark));
  }
  return all;
}

TEST(Capture, KeepsMeasurementsInTheTraceOfTheirOutlet) {
  Capture capture;
  capture.add({measurement("a", 128, 50.0F), measurement("b", 128, 49.0F)});
  capture.add({measurement("a", 256, std::numeric_limits<float>::quiet_NaN())});
  EXPECT_EQ(capture.last_report_sample("a"), 256);
  EXPECT_EQ(capture.last_report_sample("b"), 128);
  const record::MeasurementTrace first = taken(capture, "a").trace;
  EXPECT_THAT(first.tick, ElementsAre(128, 256));
  EXPECT_EQ(first.frequency_hz[0], 50.0F);
  EXPECT_TRUE(std::isnan(first.frequency_hz[1]));
  EXPECT_THAT(first.rocof_hz_s, ElementsAre(-0.5F, -0.5F));
  EXPECT_THAT(first.voltage_pu, ElementsAre(0.99F, 0.99F));
  EXPECT_THAT(first.validity, ElementsAre(2, 2));
  EXPECT_THAT(taken(capture, "b").trace.frequency_hz, ElementsAre(49.0F));
}

TEST(Capture, HasNoReportsOfASilentOutlet) {
  const Capture capture{};
  EXPECT_EQ(capture.last_report_sample("a"), 0);
  EXPECT_TRUE(capture.settings_answers("a").empty());
}

TEST(Capture, KeepsEventsEdgesAndCommandsAsMarks) {
  Capture capture;
  link::Received lse = received("a", 200, UplinkKind::kLse);
  lse.message.lse = {450.0F};
  link::Received shed = received("a", 300, UplinkKind::kDecision);
  shed.message.decision = {515.0F, 2.0F, 49.0F, 163.0F, 20.0F, 30, Trust::kTrusted, true};
  capture.add({event("a", 100), lse, shed, relay_report("a", 300, false),
               received("a", 400, UplinkKind::kAborted)});
  capture.add_edge("a", 310, false);
  capture.add_edge("a", 900, true);
  capture.add_command("a", 800, true);
  capture.add_settings("a", 850, 7, "accumulated_mw = 120");
  capture.add_settings("a", 880, 8, "");
  EXPECT_THAT(
      printed(taken(capture, "a")),
      ElementsAre("100 event 49 frequency before it, Hz", "200 lse 450 MW", "300 decision 163 shed",
                  "300 decision.loss 515 MW", "300 decision.sigma 2 MW", "300 decision.nadir 49 Hz",
                  "300 decision.shed_before 20 MW", "300 decision.hits 30 ",
                  std::string("300 decision.trust 1 ") + to_string(Trust::kTrusted),
                  "300 relay.reported 0 loss", "310 relay.sense 0 open",
                  "400 aborted 0 voltage lost", "800 command 1 switch on",
                  "850 settings 7 accumulated_mw = 120", "880 settings 8 unchanged",
                  "900 relay.sense 1 closed"));
}

TEST(Capture, MarksADecisionToHoldWithTheReliabilityOfItsEstimate) {
  Capture capture;
  link::Received hold = received("a", 300, UplinkKind::kDecision);
  hold.message.decision = {515.0F, 2.5F, NAN, 163.0F, 0.0F, 3, Trust::kNotYet, false};
  capture.add({hold});
  const record::Reports reports = taken(capture, "a");
  EXPECT_EQ(reports.marks[0].text, std::string("hold; estimate ") + to_string(Trust::kNotYet));
  EXPECT_EQ(printed(reports.marks.back()),
            std::string("300 decision.trust 0 ") + to_string(Trust::kNotYet));
}

TEST(Capture, SortsMarksByTimeAndKeepsTheOrderWithinOneTick) {
  Capture capture;
  capture.add({relay_report("a", 500, false), event("a", 700)});
  capture.add_edge("a", 600, false);
  capture.add_edge("a", 500, true);
  capture.add_command("a", 400, false);
  EXPECT_THAT(printed(taken(capture, "a")),
              ElementsAre("400 command 0 switch off", "500 relay.reported 0 loss",
                          "500 relay.sense 1 closed", "600 relay.sense 0 open",
                          "700 event 49 frequency before it, Hz"));
}

TEST(Capture, ConvertsTheInstantOfTheLossToTheTimeBaseOfTheRun) {
  Capture capture;
  // An event at 3.12 s, a loss 0.11 s before it; then another event.
  capture.add({event("a", 24960), estimate(25088, -0.11F, Trust::kNotYet),
               estimate(25216, -0.12F, Trust::kTrusted), event("a", 80000),
               estimate(80128, -0.1F, Trust::kTrusted)});
  const record::EstimateTrace estimates = taken(capture, "a").estimates;
  EXPECT_THAT(estimates.tick, ElementsAre(25088, 25216, 80128));
  EXPECT_NEAR(record::loss_instant_s(estimates, 0, kRate_hz), 3.01, 1e-6);
  EXPECT_NEAR(record::loss_instant_s(estimates, 1, kRate_hz), 3.00, 1e-6);
  EXPECT_NEAR(record::loss_instant_s(estimates, 2, kRate_hz), 9.90, 1e-6);
  EXPECT_THAT(estimates.trusted, ElementsAre(0, 1, 1));
  EXPECT_THAT(estimates.loss_mw, ElementsAre(500.0F, 500.0F, 500.0F));
  EXPECT_THAT(estimates.loss_sigma_mw, ElementsAre(8.0F, 8.0F, 8.0F));
}

TEST(Capture, KeepsTheAnswersToTheSettingsAndTheDigestOfTheFirst) {
  Capture capture;
  link::Received accepted = received("a", 40, UplinkKind::kSettingsAnswer);
  accepted.message.settings_answer = {gs::outlet::SettingsError::kNone, 1, 0x00C0FFEEU};
  link::Received refused = received("b", 40, UplinkKind::kSettingsAnswer);
  refused.message.settings_answer = {gs::outlet::SettingsError::kConditions, 0, 0};
  link::Received later = received("a", 800, UplinkKind::kSettingsAnswer);
  later.message.settings_answer = {gs::outlet::SettingsError::kStale, 1, 0x00BADBADU};
  capture.add({accepted, refused});
  capture.add({later});
  EXPECT_THAT(capture.settings_answers("a"),
              ElementsAre(gs::outlet::SettingsError::kNone, gs::outlet::SettingsError::kStale));
  EXPECT_THAT(capture.settings_answers("b"), ElementsAre(gs::outlet::SettingsError::kConditions));
  EXPECT_EQ(capture.settings_digest("a"), "00c0ffee");
  EXPECT_THAT(printed(taken(capture, "a")),
              ElementsAre(std::string("800 settings.answer 1 refused: ") +
                          to_string(gs::outlet::SettingsError::kStale)));
}

TEST(Capture, IsEmptyAfterItsContentIsTaken) {
  Capture capture;
  capture.add(
      {measurement("a", 128, 50.0F), event("a", 200), estimate(300, 0.0F, Trust::kTrusted)});
  taken(capture, "a");
  const record::Reports again = taken(capture, "a");
  EXPECT_TRUE(again.trace.tick.empty());
  EXPECT_TRUE(again.marks.empty());
  EXPECT_TRUE(again.estimates.tick.empty());
}

TEST(Capture, SeparatesTheOutlets) {
  Capture capture;
  capture.add({measurement("b", 128, 50.0F), event("h", 200), event("a", 300)});
  capture.add_edge("b", 400, false);
  EXPECT_THAT(printed(taken(capture, "a")), ElementsAre("300 event 49 frequency before it, Hz"));
}

TEST(Capture, MakesNoMarkOfAHello) {
  Capture capture;
  capture.add({received("a", 0, UplinkKind::kHello)});
  EXPECT_TRUE(taken(capture, "a").marks.empty());
}

}  // namespace
}  // namespace gsbench::capture
