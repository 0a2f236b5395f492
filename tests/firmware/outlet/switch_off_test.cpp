// Criteria (2) and (3) of §5.5: switching-off frequency and commands.
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace gs::outlet {
namespace {

using Reports = std::vector<Report>;

// Steady frequency, then `lowest_hz` for `duration_s`, and back.
Reports reports_of_visit(double lowest_hz, double duration_s) {
  test::MainsSpec spec = {gsbench::waveform::reference_from_points(
      50.0,
      {{1.0, 49.05}, {1.2, lowest_hz}, {1.2 + duration_s, lowest_hz}, {1.4 + duration_s, 49.05}})};
  return test::reports_of(spec, 2.0 + duration_s, test::ieee24_settings());
}

TEST(SwitchOffFrequency, TripsAfterThreeSuccessiveMeasurementsBelowIt) {
  int tripped = 0;
  int spared = 0;
  for (double lowest_hz = 49.03; lowest_hz > 48.9; lowest_hz -= 0.004) {
    int in_a_row = 0;
    bool open = false;
    for (const Report& report : reports_of_visit(lowest_hz, 0.02)) {
      const bool below = report.measurement.validity == Validity::kValid &&
                         report.measurement.frequency_hz < 49.0F;
      in_a_row = below ? in_a_row + 1 : 0;
      if (!open && in_a_row == 3) {
        EXPECT_NE(report.happened & kRelay, 0) << lowest_hz;
        EXPECT_EQ(report.cause, Cause::kFrequency);
        open = true;
      }
      ASSERT_EQ(report.relay_closed, !open) << lowest_hz;
    }
    (open ? tripped : spared) += 1;
  }
  EXPECT_GT(tripped, 3);
  EXPECT_GT(spared, 3);
}

TEST(SwitchOffFrequency, DoesNotTripWhileTheBusIsDead) {
  test::MainsSpec spec = {gsbench::waveform::reference_from_points(
      50.0, {{0.0, 50.0}, {1.3, 50.0}, {1.5, 47.0}, {2.0, 47.0}, {2.2, 50.0}})};
  spec.signal.amplitude_steps = {{1.0, 1.5, 0.0}};
  const Reports reports = test::reports_of(spec, 4.0, test::ieee24_settings());
  EXPECT_TRUE(reports.back().relay_closed);
  EXPECT_EQ(reports.back().measurement.validity, Validity::kValid);
}

// With a clock error of 1 %, healthy mains would be measured below f^B.
TEST(SwitchOffFrequency, IsIgnoredWithoutACrystal) {
  for (const bool has_crystal : {true, false}) {
    test::PlayedOutlet outlet({test::steady(50.0, 48.0)});
    Hardware hardware = outlet.mains.hardware();
    hardware.has_crystal = has_crystal;
    ASSERT_TRUE(configure(hardware, outlet.config));
    ASSERT_EQ(apply(outlet.config, outlet.state, test::ieee24_settings()), SettingsError::kNone);
    std::size_t valid = 0;
    Report last;
    outlet.play(2.0, [&](const Report& report) {
      valid += report.measurement.validity == Validity::kValid ? 1U : 0U;
      last = report;
    });
    EXPECT_EQ(valid > 0, has_crystal);
    EXPECT_EQ(last.relay_closed, !has_crystal);
    EXPECT_NEAR(last.measurement.voltage_pu, 1.0F, 0.02F);
    EXPECT_TRUE(command(outlet.state, has_crystal)) << "commands are obeyed";
  }
}

TEST(SwitchOffFrequency, TripsWhenADeadBusReturnsBelowIt) {
  test::MainsSpec spec = {test::steady(50.0, 48.0)};
  spec.signal.amplitude_steps = {{0.0, 1.0, 0.0}};
  const Reports reports = test::reports_of(spec, 2.0, test::ieee24_settings());
  const auto opened = std::find_if(reports.begin(), reports.end(), [](const Report& report) {
    return (report.happened & kRelay) != 0;
  });
  ASSERT_NE(opened, reports.end());
  EXPECT_EQ(opened->cause, Cause::kFrequency);
  EXPECT_GT(test::report_s(*opened), 1.0);
}

TEST(Command, OpensAndClosesTheRelay) {
  State state;
  EXPECT_TRUE(command(state, false));
  EXPECT_FALSE(state.relay.closed);
  EXPECT_EQ(state.relay.cause, Cause::kCommand);
  EXPECT_TRUE(command(state, true));
  EXPECT_TRUE(state.relay.closed);
  EXPECT_EQ(state.relay.cause, Cause::kNone);
}

TEST(Command, ThatChangesNothingKeepsTheCause) {
  State state;
  EXPECT_FALSE(command(state, true));
  state.relay.closed = false;
  state.relay.cause = Cause::kLoss;
  EXPECT_FALSE(command(state, false));
  EXPECT_EQ(state.relay.cause, Cause::kLoss);
}

TEST(Command, ToCloseDoesNotOverrideTheSwitchOffFrequency) {
  test::PlayedOutlet outlet({test::steady(50.0, 48.5)}, test::ieee24_settings());
  int reports = 0;
  const auto count = [&](const Report&) { ++reports; };
  outlet.play(1.0, count);
  ASSERT_FALSE(outlet.state.relay.closed);
  EXPECT_TRUE(command(outlet.state, true));
  reports = 0;
  // 8000 samples are 62.5 reports: half a report completes the next one.
  outlet.play(8000, 8064, count);
  ASSERT_EQ(reports, 1);
  EXPECT_FALSE(outlet.state.relay.closed);
  EXPECT_EQ(outlet.state.relay.cause, Cause::kFrequency);
}

TEST(Cause, EachHasItsOwnName) {
  EXPECT_STREQ(to_string(Cause::kNone), "none");
  EXPECT_STREQ(to_string(Cause::kLoss), "loss");
  EXPECT_STREQ(to_string(Cause::kFrequency), "frequency");
  EXPECT_STREQ(to_string(Cause::kCommand), "command");
}

}  // namespace
}  // namespace gs::outlet
