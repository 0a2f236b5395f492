#include <control_centre/blocks.hpp>
#include <control_centre/outlet_settings.hpp>
#include <control_centre/threshold.hpp>
#include <grid_test/example_grids.hpp>
#include <test_support/refusal.hpp>

#include <gmock/gmock.h>

#include <grid/sfr_model.hpp>
#include <outlet/settings.hpp>

namespace gsbench::control_centre {
namespace {

using gs::outlet::Settings;
using ::testing::AllOf;
using ::testing::HasSubstr;

Settings settings_of(const RequestedSettings& requested) {
  return outlet_settings(grid::ieee24(), requested, 1);
}

RequestedSettings behind(double accumulated_mw) {
  RequestedSettings requested;
  requested.accumulated_mw = accumulated_mw;
  return requested;
}

TEST(OutletSettings, AreDerivedFromTheGrid) {
  const grid::Grid grid = grid::ieee24();
  const grid::SfrModel model(grid);
  const Settings s = outlet_settings(grid, behind(100.0), 9);
  EXPECT_EQ(s.version, 9U);
  EXPECT_EQ(s.response.gain_hz_per_mw, static_cast<float>(model.gain_hz_per_mw()));
  EXPECT_EQ(s.response.sigma_per_s, static_cast<float>(model.sigma_per_s()));
  EXPECT_EQ(s.response.discriminant_per_s2, static_cast<float>(model.discriminant_per_s2()));
  EXPECT_EQ(s.response.initial_slope_per_s, static_cast<float>(model.initial_slope_per_s()));
  EXPECT_EQ(s.largest_loss_mw, static_cast<float>(grid.base_mw));
  EXPECT_EQ(s.accumulated_mw, 100.0F);
  EXPECT_EQ(s.threshold_mw, static_cast<float>(delay_aware_threshold_mw(grid)));
}

// The paper's threshold, within its rounding.
TEST(OutletSettings, ByThePapersRulesHaveTheThresholdOfEquation15) {
  RequestedSettings requested = behind(100.0);
  requested.rules = Rules::kPaper;
  EXPECT_NEAR(static_cast<double>(settings_of(requested).threshold_mw), 351.92, 0.1);
}

TEST(OutletSettings, ContainEachRowOfTheConditions) {
  const grid::Grid grid = grid::ieee24();
  const auto rows = conditions(grid::SfrModel(grid), grid.threshold_hz, grid.condition_row_hz);
  const Settings s = settings_of({});
  ASSERT_EQ(s.condition_rows, rows.size());
  ASSERT_EQ(rows.size(), 10U) << "from 50 to 49.5 Hz in rows of 0.05 Hz";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_EQ(s.conditions[row].from_hz, static_cast<float>(rows[row].from_hz));
    EXPECT_EQ(s.conditions[row].rocof_below_hz_s, static_cast<float>(rows[row].rocof_below_hz_s));
  }
}

TEST(OutletSettings, KeepTheFirmwaresDefaultsIfNothingIsRequested) {
  const Settings defaults;
  const Settings s = settings_of({});
  EXPECT_EQ(s.condition_hits, defaults.condition_hits);
  EXPECT_EQ(s.event_drop_hz, defaults.event_drop_hz);
  EXPECT_EQ(s.event_departure_hz, defaults.event_departure_hz);
  EXPECT_EQ(s.lse_samples, defaults.lse_samples);
  EXPECT_EQ(s.ekf_samples, defaults.ekf_samples);
  EXPECT_EQ(s.tracker.innovation_gate_rad, defaults.tracker.innovation_gate_rad);
}

RequestedSettings with(const std::string& setting, double value) {
  RequestedSettings requested;
  requested.settings[setting] = value;
  return requested;
}

// Each field except the conditions, which cannot be set.
TEST(OutletSettings, TakeTheRequestedValueOfEachField) {
  for (const gs::outlet::Field& field : gs::outlet::kSettingsFields) {
    if (field.type == gs::outlet::FieldType::kRows) {
      continue;
    }
    const double default_value = described(settings_of({})).at(field.name);
    const bool whole = field.type != gs::outlet::FieldType::kFloat;
    const auto most = static_cast<double>(field.range.most);
    const double requested_value = !whole                 ? 0.999 * default_value + 1e-6
                                   : default_value < most ? default_value + 1.0
                                                          : default_value - 1.0;
    const auto all = described(settings_of(with(field.name, requested_value)));
    EXPECT_EQ(all.at(field.name), static_cast<double>(static_cast<float>(requested_value)))
        << field.name;
  }
}

TEST(OutletSettings, HaveTheSwitchOffFrequencyOfABlockWithTheSamePowers) {
  grid::Grid grid = grid::ieee24();
  grid.blocks = {{"a", 50.0}, {"b", 100.0}, {"c", 25.0}};
  for (const Rules rules : {Rules::kGsbench, Rules::kPaper}) {
    for (const BlockSetting& block : block_settings(grid, Accumulation::kHalfGroup, rules)) {
      RequestedSettings requested = behind(block.accumulated_mw);
      requested.power_mw = block.power_mw;
      requested.rules = rules;
      requested.staged_backup = rules == Rules::kGsbench;
      EXPECT_EQ(outlet_settings(grid, requested, 1).switch_off_hz,
                static_cast<float>(block.switch_off_hz));
    }
  }
}

TEST(OutletSettings, ByThePapersRulesAssumeABlockAsLargeAsTheAccumulatedPower) {
  RequestedSettings requested = behind(100.0);
  requested.rules = Rules::kPaper;
  EXPECT_EQ(settings_of(requested).switch_off_hz,
            static_cast<float>(eq17_switch_off_hz(grid::ieee24(), 50.0, 100.0)));
  requested.accumulated_mw = 0.0;
  EXPECT_EQ(settings_of(requested).switch_off_hz, 49.5F);
}

// A threshold above any loss, as in the profile of the backup criterion, must not change the
// estimate.
TEST(OutletSettings, DeriveTheSpreadOfTheEstimateFromTheGridNotTheRequestedThreshold) {
  EXPECT_EQ(settings_of(with("threshold_mw", 2000.0)).loss_sigma_mw, settings_of({}).loss_sigma_mw);
}

std::string refusal(const RequestedSettings& requested, const grid::Grid& grid = grid::ieee24()) {
  return test::refusal_of<std::invalid_argument>(
      [&] { (void)outlet_settings(grid, requested, 1); });
}

TEST(OutletSettings, AreRefusedOutsideTheirRange) {
  EXPECT_EQ(refusal(with("switch_off_hz", 39.0)),
            "switch_off_hz is 39; it must be a number from 40 to 50 Hz");
  EXPECT_EQ(refusal(with("event_drop_hz", 2.0)),
            "event_drop_hz is 2; it must be a number from 0 to 1 Hz");
  EXPECT_EQ(refusal(with("threshold_mw", -1.0)),
            "threshold_mw is -1; it must be a number from above 0 to 1e+09 MW");
  EXPECT_THAT(refusal(with("lse_samples", 2.5)), HasSubstr("a whole number from 2 to 64"));
  EXPECT_THAT(refusal(with("event_drops_hz", 5.0)), HasSubstr("event_drops_hz is not a setting"));
  EXPECT_THAT(refusal(with("conditions", 5.0)),
              HasSubstr("conditions cannot be set; they are derived from the grid"));
  // A count must not overflow into a valid one.
  EXPECT_THAT(refusal(with("condition_hits", 65536.0 + 20.0)),
              HasSubstr("condition_hits is 65556"));
  EXPECT_THAT(refusal(with("ekf_samples", -246.0)), HasSubstr("ekf_samples is -246"));
}

// By the least f^B of the firmware; and with much damping, by the load.
TEST(OutletSettings, AreRefusedAboveTheLargestAccumulatedPower) {
  for (const auto& [damping_pu, expected_mw] : {std::pair{2.5, 1053.6}, {20.0, 1830.0}}) {
    grid::Grid grid = grid::ieee24();
    grid.damping_pu = damping_pu;
    const double most_mw = largest_accumulated_mw(grid);
    EXPECT_NEAR(most_mw, expected_mw, 0.1);
    EXPECT_EQ(refusal(behind(0.9999 * most_mw), grid), "");
    EXPECT_NE(refusal(behind(1.0001 * most_mw), grid), "");
    grid.damping_pu = 0.0;
    EXPECT_EQ(largest_accumulated_mw(grid), 0.0);
    EXPECT_EQ(refusal(behind(0.0), grid), "");
  }
}

TEST(OutletSettings, AreRefusedWithTheReasonOfTheFirmware) {
  EXPECT_THAT(refusal(with("loss_sigma_mw", 3000.0)),
              HasSubstr(to_string(gs::outlet::SettingsError::kEstimator)));
  RequestedSettings requested = behind(100.0);
  requested.power_mw = 201.0;
  requested.rules = Rules::kPaper;
  EXPECT_THAT(refusal(requested), HasSubstr("power_mw is 201"));
}

TEST(OutletSettings, RefuseMoreConditionsThanAnOutletStores) {
  grid::Grid grid = grid::ieee24();
  grid.condition_row_hz = 0.5 / gs::outlet::kMaxConditions;
  EXPECT_EQ(refusal({}, grid), "");
  grid.condition_row_hz = 0.5 / (gs::outlet::kMaxConditions + 1);
  EXPECT_THAT(refusal({}, grid),
              AllOf(HasSubstr("condition_row_hz"), HasSubstr("33"), HasSubstr("at most 32")));
}

TEST(DescribedSettings, ContainEveryField) {
  const Settings s = settings_of(behind(100.0));
  const auto all = described(s);
  // The conditions are their number and two values per row.
  EXPECT_EQ(all.size(), std::size(gs::outlet::kSettingsFields) + 20U);
  EXPECT_EQ(all.at("version"), 1.0);
  EXPECT_EQ(all.at("accumulated_mw"), 100.0);
  EXPECT_EQ(all.at("dead_bus_pu"), static_cast<double>(s.tracker.dead_bus_pu));
  EXPECT_EQ(all.at("condition_rows"), 10.0);
  EXPECT_EQ(all.at("condition_01_from_hz"), static_cast<double>(s.conditions[0].from_hz));
  EXPECT_EQ(all.at("condition_10_rocof_below_hz_s"), 0.0);
  // The judge needs it.
  EXPECT_EQ(all.at("event_drop_hz"), static_cast<double>(s.event_drop_hz));
}

}  // namespace
}  // namespace gsbench::control_centre
