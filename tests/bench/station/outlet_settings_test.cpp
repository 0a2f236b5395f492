#include "plans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <grid/control_centre.hpp>
#include <profile/load.hpp>
#include <station/outlet_settings.hpp>

namespace gsbench::station::test {
namespace {

using gs::outlet::Settings;
using ::testing::AllOf;
using ::testing::HasSubstr;

// The outlet's whole table in a profile on ieee24.
profile::Plan with_outlet(const std::string& keys) {
  return plan(1.0, "", "[[outlet]]\nid = \"mine\"\n" + keys);
}

Settings settings_of(const profile::Plan& plan) {
  return outlet_settings(plan, plan.outlets.front(), 1);
}

TEST(OutletSettings, AreThoseOfTheControlCentre) {
  const profile::Plan plan = with_outlet("accumulated_mw = 100.0\n");
  const grid::SfrModel model(plan.grid);
  const Settings s = outlet_settings(plan, plan.outlets.front(), 9);
  EXPECT_EQ(s.version, 9U);
  EXPECT_EQ(s.response.gain_hz_per_mw, static_cast<float>(model.gain_hz_per_mw()));
  EXPECT_EQ(s.response.sigma_per_s, static_cast<float>(model.sigma_per_s()));
  EXPECT_EQ(s.response.discriminant_per_s2, static_cast<float>(model.discriminant_per_s2()));
  EXPECT_EQ(s.response.initial_slope_per_s, static_cast<float>(model.initial_slope_per_s()));
  EXPECT_EQ(s.largest_loss_mw, static_cast<float>(plan.grid.base_mw));
  EXPECT_EQ(s.accumulated_mw, 100.0F);
  // Printed in the paper, ±0.1 for what it rounds.
  EXPECT_NEAR(static_cast<double>(s.threshold_mw), 351.92, 0.1);
  EXPECT_EQ(s.switch_off_hz, static_cast<float>(grid::switch_off_hz(plan.grid, 100.0, 100.0)));
}

TEST(OutletSettings, CarryEachRowOfTheConditions) {
  const profile::Plan plan = with_outlet("");
  const auto rows = grid::conditions(grid::SfrModel(plan.grid), plan.grid.threshold_hz,
                                     plan.grid.condition_row_hz);
  const Settings s = settings_of(plan);
  ASSERT_EQ(s.condition_rows, rows.size());
  ASSERT_EQ(rows.size(), 10U) << "from 50 to 49.5 Hz in rows of 0.05 Hz";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(s.conditions[row].from_hz, static_cast<float>(rows[row].from_hz));
    EXPECT_EQ(s.conditions[row].rocof_below_hz_s, static_cast<float>(rows[row].rocof_below_hz_s));
  }
}

TEST(OutletSettings, LeaveTheFirmwaresDefaultsWhereTheProfileSaysNothing) {
  const Settings defaults;
  const Settings s = settings_of(with_outlet(""));
  EXPECT_EQ(s.condition_hits, defaults.condition_hits);
  EXPECT_EQ(s.event_drop_hz, defaults.event_drop_hz);
  EXPECT_EQ(s.event_departure_hz, defaults.event_departure_hz);
  EXPECT_EQ(s.lse_samples, defaults.lse_samples);
  EXPECT_EQ(s.ekf_samples, defaults.ekf_samples);
  EXPECT_EQ(s.tracker.leap_rad, defaults.tracker.leap_rad);
}

TEST(OutletSettings, TakeWhatTheProfileSays) {
  const Settings s =
      settings_of(with_outlet("threshold_mw = 400.0\nswitch_off_hz = 49.25\nevent_drop_hz = 0.05\n"
                              "event_departure_hz = 0.06\n"
                              "condition_hits = 0\nlse_samples = 12\nekf_samples = 30\n"));
  EXPECT_EQ(s.threshold_mw, 400.0F);
  EXPECT_EQ(s.switch_off_hz, 49.25F);
  EXPECT_EQ(s.event_drop_hz, 0.05F);
  EXPECT_EQ(s.event_departure_hz, 0.06F);
  EXPECT_EQ(s.condition_hits, 0);
  EXPECT_EQ(s.lse_samples, 12);
  EXPECT_EQ(s.ekf_samples, 30);
}

TEST(OutletSettings, SwitchOffFrequencyIsThatOfTheOutletsOwnBlock) {
  const profile::Plan plan = with_outlet("accumulated_mw = 300.0\npower_mw = 50.0\n");
  const Settings s = settings_of(plan);
  EXPECT_EQ(s.switch_off_hz, static_cast<float>(grid::switch_off_hz(plan.grid, 300.0, 50.0)));
  EXPECT_NE(s.switch_off_hz, static_cast<float>(grid::switch_off_hz(plan.grid, 300.0, 300.0)));
}

TEST(OutletSettings, SwitchOffFrequencyIsTheThresholdWhereNothingIsShedBefore) {
  EXPECT_EQ(settings_of(with_outlet("accumulated_mw = 0.0\n")).switch_off_hz, 49.5F);
}

// A threshold raised out of reach, as the backup's test has it, must not blunt the estimate.
TEST(OutletSettings, EstimatesSpreadIsThatOfTheGridNotOfTheProfilesThreshold) {
  EXPECT_EQ(settings_of(with_outlet("threshold_mw = 2000.0\n")).loss_sigma_mw,
            settings_of(with_outlet("")).loss_sigma_mw);
}

std::string refusal(const profile::Plan& plan) {
  try {
    settings_of(plan);
  } catch (const profile::ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(OutletSettings, NameTheOutletAndTheReasonWhereTheFirmwareWouldRefuse) {
  profile::Plan plan = with_outlet("");
  plan.outlets[0].settings.switch_off_hz = 39.0;
  EXPECT_THAT(refusal(plan), AllOf(HasSubstr("test.toml"), HasSubstr("mine"),
                                   HasSubstr(to_string(gs::outlet::SettingsError::kSwitchOff))));
  plan = with_outlet("");
  plan.outlets[0].settings.event_drop_hz = 2.0;
  EXPECT_THAT(refusal(plan), HasSubstr(to_string(gs::outlet::SettingsError::kEvent)));
  plan = with_outlet("");
  plan.outlets[0].settings.lse_samples = 1;
  EXPECT_THAT(refusal(plan), HasSubstr(to_string(gs::outlet::SettingsError::kCounts)));
}

// A count must not wrap round into one that would do.
TEST(OutletSettings, RefuseCountsThatTheFirmwaresFieldsCannotHold) {
  for (const int count : {-1, 65536 + 20}) {
    profile::Plan plan = with_outlet("");
    plan.outlets[0].settings.condition_hits = count;
    EXPECT_THAT(refusal(plan), AllOf(HasSubstr("condition_hits"), HasSubstr("out of")));
  }
  for (const int count : {-246, 256 + 10}) {
    profile::Plan plan = with_outlet("");
    plan.outlets[0].settings.lse_samples = count;
    EXPECT_THAT(refusal(plan), HasSubstr("lse_samples"));
    plan = with_outlet("");
    plan.outlets[0].settings.ekf_samples = count;
    EXPECT_THAT(refusal(plan), HasSubstr("ekf_samples"));
  }
}

TEST(OutletSettings, RefuseMoreConditionsThanAnOutletKeeps) {
  profile::Plan plan = with_outlet("");
  plan.grid.condition_row_hz = 0.5 / gs::outlet::kMaxConditions;
  EXPECT_EQ(refusal(plan), "");
  plan.grid.condition_row_hz = 0.5 / (gs::outlet::kMaxConditions + 1);
  EXPECT_THAT(refusal(plan),
              AllOf(HasSubstr("condition_row_hz"), HasSubstr("33"), HasSubstr("32 at most")));
}

TEST(DescribedSettings, TellTheValuesThatWereSent) {
  const Settings s = settings_of(with_outlet("accumulated_mw = 100.0\nlse_samples = 12\n"));
  const auto described = station::described(s);
  EXPECT_EQ(described.at("version"), 1.0);
  EXPECT_EQ(described.at("threshold_mw"), static_cast<double>(s.threshold_mw));
  EXPECT_EQ(described.at("accumulated_mw"), 100.0);
  EXPECT_EQ(described.at("switch_off_hz"), static_cast<double>(s.switch_off_hz));
  EXPECT_EQ(described.at("lse_samples"), 12.0);
  EXPECT_EQ(described.at("condition_rows"), 10.0);
  // The judge asks for it.
  EXPECT_EQ(described.at("event_drop_hz"), static_cast<double>(s.event_drop_hz));
}

}  // namespace
}  // namespace gsbench::station::test
