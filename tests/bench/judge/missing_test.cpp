// A missing measurement has a reason, and is FAIL or INCONCLUSIVE as documented.

#include "synthetic_case.hpp"

#include <cmath>
#include <set>

#include <gmock/gmock.h>

namespace gsbench::judge::test {
namespace {

using ::testing::HasSubstr;

struct Missing {
  const char* measure;
  bool fails;
  const char* reason;
  Change change;
};

void no_loss(SyntheticCase& c) {
  c.plan.stimulus.losses.clear();
}

void no_sense(SyntheticCase& c) {
  c.outlet.relay_sensed = false;
}

void no_clock(SyntheticCase& c) {
  c.outlet.clock = {};
}

Change without(const char* kind) {
  return [kind](SyntheticCase& c) { c.remove_marks(kind); };
}

// Six invalid reports and nine valid ones.
void nine_valid_reports(SyntheticCase& c) {
  c.cut_trace(15);
}

const std::vector<Missing>& all_missing() {
  static const std::vector<Missing> all = {
      {"tracker.error.max", true, "fewer than 10 valid reports", nine_valid_reports},
      {"tracker.error.rms", true, "fewer than 10 valid reports", nine_valid_reports},
      {"tracker.bias", true, "fewer than 10 valid reports", nine_valid_reports},
      {"tracker.rocof_error.rms", true, "fewer than 10 valid reports", nine_valid_reports},
      {"tracker.delay", false, "while the reference moves",
       [](SyntheticCase& c) { c.reference = std::make_shared<FallingReference>(1e9); }},
      {"tracker.delay", false, "while the reference moves", nine_valid_reports},
      {"validity.valid_share", true, "fewer than 10 reports after the first second",
       [](SyntheticCase& c) { c.cut_trace(71); }},
      {"event.false", false, "does not contain the outlet's setting event_drop_hz",
       [](SyntheticCase& c) { c.outlet.settings.erase("event_drop_hz"); }},
      {"event.delay", false, "contains no loss", no_loss},
      {"event.delay", true, "reported no event after the loss",
       [](SyntheticCase& c) { c.move_marks("event", -121); }},
      {"condition.hits", true, "reported no decision", without("decision.hits")},
      {"lse.loss", true, "reported no least-squares estimate", without("lse")},
      {"lse.error", true, "reported no least-squares estimate", without("lse")},
      {"lse.error", false, "contains no loss of power before", no_loss},
      {"lse.error", false, "contains no loss of power before",
       [](SyntheticCase& c) { c.move_marks("lse", -300); }},
      {"ekf.loss", true, "reported no decision", without("decision.loss")},
      {"ekf.error", true, "reported no decision", without("decision.loss")},
      {"ekf.error", false, "contains no loss of power before", no_loss},
      {"ekf.t_x_error", false, "contains no loss", no_loss},
      {"ekf.t_x_error", true, "reported no decision", without("decision")},
      {"ekf.t_x_error", true, "no EKF estimate",
       [](SyntheticCase& c) { c.outlet.reports.estimates = record::EstimateTrace{}; }},
      {"decision.trust", true, "reported no decision", without("decision.trust")},
      {"decision.delay", false, "contains no loss", no_loss},
      {"decision.delay", true, "reported no decision after the loss",
       [](SyntheticCase& c) { c.move_marks("decision", -921); }},
      {"relay.delay", false, "contains no loss", no_loss},
      {"relay.delay", true, "did not open after the loss", without("relay.sense")},
      {"relay.delay", true, "did not open after the loss",
       [](SyntheticCase& c) { c.move_marks("relay.sense", -929); }},
      {"relay.delay", false, "no relay sense", no_sense},
      {"relay.report_difference", false, "no relay sense", no_sense},
      {"relay.operate_time", false, "no relay sense", no_sense},
      {"relay.end", false, "no relay sense", no_sense},
      {"relay.edges", false, "no relay sense", no_sense},
      {"relay.chatter", false, "no relay sense", no_sense},
      {"command.delay", false, "no relay sense", no_sense},
      {"trip.time", false, "no relay sense", no_sense},
      {"relay.operate_hz", false, "no relay sense", no_sense},
      {"relay.delay_reported", false, "contains no loss", no_loss},
      {"relay.delay_reported", true, "did not report a command to open", without("relay.reported")},
      {"relay.operate_time", true, "both sensed and reported", without("relay.reported")},
      {"relay.operate_time", true, "both sensed and reported", without("relay.sense")},
      {"relay.report_difference", true, "opened but the outlet did not report it",
       without("relay.reported")},
      {"relay.report_difference", true, "reported a command to open but the contact did not open",
       without("relay.sense")},
      {"relay.report_difference", true, "no opening was sensed or reported",
       [](SyntheticCase& c) {
         c.remove_marks("relay.reported");
         c.remove_marks("relay.sense");
       }},
      {"command.delay", false, "sends no command to this outlet", without("command")},
      {"command.delay", true, "did not follow the command",
       [](SyntheticCase& c) {
         c.add_mark(2000, "command", 0.0);
         c.remove_marks("relay.sense");
       }},
      {"trip.time", true, "did not open", without("relay.sense")},
      {"relay.operate_hz", true, "did not open", without("relay.sense")},
      {"clock.drift", false, "counts the source's ticks", no_clock},
      {"clock.uncertainty", false, "counts the source's ticks", no_clock},
  };
  return all;
}

// With the widest limits: FAIL if the outlet did not act, INCONCLUSIVE if the bench could not
// measure.
TEST(MissingMeasurement, HasAReasonAndNeverPasses) {
  for (const Missing& missing : all_missing()) {
    SyntheticCase c = loss_of_500_mw();
    missing.change(c);
    const Reading reading = c.read(missing.measure);
    EXPECT_THAT(reading.missing, HasSubstr(missing.reason)) << missing.measure;
    EXPECT_EQ(reading.missing_fails, missing.fails) << missing.measure;
    EXPECT_TRUE(std::isnan(reading.value)) << missing.measure;
    EXPECT_EQ(verdict(c, limits(missing.measure, -1e300, 1e300)),
              missing.fails ? record::Verdict::kFail : record::Verdict::kInconclusive)
        << missing.measure;
  }
}

TEST(MissingMeasurement, IsTestedForEveryMeasureWithNeeds) {
  std::set<std::string> tested;
  for (const Missing& missing : all_missing()) {
    tested.insert(missing.measure);
  }
  for (const measures::Measure& measure : measures::catalogue()) {
    EXPECT_EQ(tested.count(measure.name) > 0, measure.needs != "nothing") << measure.name;
  }
}

// One report more than in the cases above.
TEST(MissingMeasurement, HasAValueWithTenReports) {
  SyntheticCase c = loss_of_500_mw();
  c.cut_trace(16);
  EXPECT_EQ(c.read("tracker.error.rms").missing, "");
  c = loss_of_500_mw();
  c.cut_trace(72);
  EXPECT_EQ(c.read("validity.valid_share").missing, "");
}

}  // namespace
}  // namespace gsbench::judge::test
