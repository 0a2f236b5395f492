#include <firmware_test/settings.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <outlet/outlet.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct InvalidSetting {
  const char* what;
  SettingsError error;
  std::function<void(Settings&)> make_invalid;
};

std::vector<InvalidSetting> invalid_settings() {
  using S = Settings&;
  using E = SettingsError;
  return {
      {"gain NaN", E::kResponse, [](S s) { s.response.gain_hz_per_mw = kNotANumber; }},
      {"threshold infinite", E::kThreshold, [](S s) { s.threshold_mw = kInfinity; }},
      {"largest loss above the limit", E::kThreshold, [](S s) { s.largest_loss_mw = 2e9F; }},
      {"condition NaN", E::kConditions,
       [](S s) { s.conditions[3].rocof_below_hz_s = kNotANumber; }},
      {"phase gate NaN", E::kTracker, [](S s) { s.tracker.innovation_gate_rad = kNotANumber; }},
      {"gain 0", E::kResponse, [](S s) { s.response.gain_hz_per_mw = 0.0F; }},
      {"gain of the wrong sign", E::kResponse, [](S s) { s.response.gain_hz_per_mw *= -1.0F; }},
      {"initial slope 0", E::kResponse, [](S s) { s.response.initial_slope_per_s = 0.0F; }},
      {"sigma 0", E::kResponse, [](S s) { s.response.sigma_per_s = 0.0F; }},
      {"decay beyond the series", E::kResponse, [](S s) { s.response.sigma_per_s = 20.0F; }},
      {"discriminant above the series' limit", E::kResponse,
       [](S s) { s.response.discriminant_per_s2 = 12.0F; }},
      {"discriminant below the series' limit", E::kResponse,
       [](S s) { s.response.discriminant_per_s2 = -12.0F; }},
      {"unstable response", E::kResponse, [](S s) { s.response.discriminant_per_s2 = -1.0F; }},
      {"estimation time beyond the series", E::kResponse,
       [](S s) {
         s.response.discriminant_per_s2 = 5.0F;
         s.ekf_samples = 100;
       }},
      {"no threshold", E::kThreshold, [](S s) { s.threshold_mw = 0.0F; }},
      {"no largest loss", E::kThreshold, [](S s) { s.largest_loss_mw = 0.0F; }},
      {"negative accumulated power", E::kAccumulated, [](S s) { s.accumulated_mw = -1.0F; }},
      {"switches off at 39 Hz", E::kSwitchOff, [](S s) { s.switch_off_hz = 39.9F; }},
      {"switches off above nominal", E::kSwitchOff, [](S s) { s.switch_off_hz = 50.1F; }},
      {"no conditions", E::kConditions, [](S s) { s.condition_rows = 0; }},
      {"too many conditions", E::kConditions, [](S s) { s.condition_rows = kMaxConditions + 1; }},
      {"conditions out of order", E::kConditions, [](S s) { s.conditions[1] = s.conditions[0]; }},
      {"condition above nominal", E::kConditions, [](S s) { s.conditions[0].from_hz = 50.1F; }},
      {"condition on a rising frequency", E::kConditions,
       [](S s) { s.conditions[0].rocof_below_hz_s = 0.1F; }},
      {"slope over one sample", E::kCounts, [](S s) { s.rocof_samples = 1; }},
      {"slope beyond the history", E::kCounts, [](S s) { s.rocof_samples = kHistoryLength + 1; }},
      {"no drops", E::kCounts, [](S s) { s.event_drops = 0; }},
      {"drops overlap the baseline", E::kCounts, [](S s) { s.event_drops = kBaselineAge; }},
      {"LSE of one sample", E::kCounts, [](S s) { s.lse_samples = 1; }},
      {"LSE too long", E::kCounts, [](S s) { s.lse_samples = kMaxLseSamples + 1; }},
      {"no EKF", E::kCounts, [](S s) { s.ekf_samples = 0; }},
      {"EKF too long", E::kCounts, [](S s) { s.ekf_samples = 201; }},
      {"switch-off after no sample", E::kCounts, [](S s) { s.switch_off_samples = 0; }},
      {"switch-off after 51 samples", E::kCounts, [](S s) { s.switch_off_samples = 51; }},
      {"negative drop", E::kEvent, [](S s) { s.event_drop_hz = -0.001F; }},
      {"drop above 1 Hz", E::kEvent, [](S s) { s.event_drop_hz = 1.1F; }},
      {"negative departure", E::kEvent, [](S s) { s.event_departure_hz = -0.001F; }},
      {"no measurement noise", E::kEstimator, [](S s) { s.measurement_sigma_hz = 0.0F; }},
      {"σ of the loss 0", E::kEstimator, [](S s) { s.loss_sigma_mw = 0.0F; }},
      {"σ of the loss above the largest loss", E::kEstimator,
       [](S s) { s.loss_sigma_mw = 1.1F * s.largest_loss_mw; }},
      {"negative event lag", E::kEstimator, [](S s) { s.event_lag_s = -0.001F; }},
      {"event lag above 0.1 s", E::kEstimator, [](S s) { s.event_lag_s = 0.11F; }},
      {"σ of t_x 0", E::kEstimator, [](S s) { s.t_x_sigma_s = 0.0F; }},
      {"trusted residual 0", E::kEstimator, [](S s) { s.trusted_residual_hz = 0.0F; }},
      {"no phase noise", E::kTracker, [](S s) { s.tracker.phase_noise_rad = 0.0F; }},
      {"no jerk", E::kTracker, [](S s) { s.tracker.jerk_rad_s3_per_sqrt_hz = 0.0F; }},
      {"no phase gate", E::kTracker, [](S s) { s.tracker.innovation_gate_rad = 0.0F; }},
      {"no amplitude gate", E::kTracker, [](S s) { s.tracker.innovation_gate_amplitude = 0.0F; }},
      {"dead bus at 0", E::kTracker, [](S s) { s.tracker.dead_bus_pu = 0.0F; }},
      {"unknown method", E::kMethod, [](S s) { s.method = 2; }},
      {"no threshold frequency", E::kMethod, [](S s) { s.threshold_hz = 0.0F; }},
      {"delay above 5 s", E::kRelay, [](S s) { s.delay_s = 5.1F; }},
      {"restoration below 0", E::kRelay, [](S s) { s.restore_dwell_s = -1.0F; }},
      {"dead bus above 0.5", E::kTracker, [](S s) { s.tracker.dead_bus_pu = 0.6F; }},
  };
}

TEST(Settings, AreAcceptedIfValid) {
  EXPECT_EQ(validate(test::ieee24_settings(), 50.0F), SettingsError::kNone);
}

// Tests both ends of each range, and values just outside.
TEST(Settings, AreAcceptedOnlyWithinTheRangesOfTheList) {
  for (const Field& field : kSettingsFields) {
    if (field.type == FieldType::kRows) {
      continue;
    }
    const float scale = field.range.of_nominal ? 50.0F : 1.0F;
    EXPECT_NE(within(field.range, field.range.least * scale, 50.0F), field.range.without_least);
    EXPECT_NE(within(field.range, field.range.most * scale, 50.0F), field.range.without_most);
    const float beyond[] = {std::nextafter(field.range.least * scale, -kInfinity),
                            std::nextafter(field.range.most * scale, kInfinity), kNotANumber};
    for (const float value : beyond) {
      EXPECT_FALSE(within(field.range, value, 50.0F)) << field.name;
      if (field.type != FieldType::kFloat) {
        continue;
      }
      Settings settings = test::ieee24_settings();
      member<float>(settings, field) = value;
      EXPECT_EQ(validate(settings, 50.0F), field.error) << field.name << " = " << value;
    }
  }
}

TEST(Settings, EveryErrorOccursAndHasItsOwnText) {
  std::set<SettingsError> reached = {SettingsError::kNone, SettingsError::kUnknownField,
                                     SettingsError::kStale};
  for (const InvalidSetting& invalid : invalid_settings()) {
    reached.insert(invalid.error);
  }
  std::set<std::string> words;
  for (const SettingsError error : reached) {
    words.insert(to_string(error));
  }
  EXPECT_EQ(reached.size(), static_cast<std::size_t>(kLastSettingsError) + 1);
  EXPECT_EQ(words.size(), reached.size());
  EXPECT_EQ(words.count("unknown"), 0U);
}

TEST(Settings, AreRefusedWithTheReasonAndLeaveTheOldOnesInForce) {
  Config config;
  State state;
  ASSERT_TRUE(configure(Hardware{}, config));
  ASSERT_EQ(apply(config, state, test::ieee24_settings()), SettingsError::kNone);
  const std::uint32_t in_force = digest(config.settings);
  for (const InvalidSetting& invalid : invalid_settings()) {
    Settings settings = test::ieee24_settings();
    settings.version = 2;
    invalid.make_invalid(settings);
    EXPECT_EQ(apply(config, state, settings), invalid.error) << invalid.what;
    EXPECT_EQ(digest(config.settings), in_force) << invalid.what;
  }
}

TEST(Settings, AreRefusedAsStaleUnlessNewerThanThoseInForce) {
  Config config;
  State state;
  ASSERT_TRUE(configure(Hardware{}, config));
  Settings settings = test::ieee24_settings();
  settings.version = 7;
  ASSERT_EQ(apply(config, state, settings), SettingsError::kNone);
  settings.accumulated_mw = 1.0F;
  for (const std::uint32_t version : {0U, 6U, 7U}) {
    settings.version = version;
    EXPECT_EQ(apply(config, state, settings), SettingsError::kStale) << version;
    EXPECT_EQ(config.settings.accumulated_mw, 100.0F);
  }
  settings.version = 8;
  EXPECT_EQ(apply(config, state, settings), SettingsError::kNone);
  EXPECT_EQ(config.settings.accumulated_mw, 1.0F);
}

// Equal to nominal is within; above it is not.
TEST(Settings, MayHaveFrequenciesAtNominal) {
  Settings settings = test::ieee24_settings();
  settings.switch_off_hz = 50.0F;
  settings.threshold_hz = 50.0F;
  settings.conditions[0].from_hz = 50.0F;
  EXPECT_EQ(validate(settings, 50.0F), SettingsError::kNone);
  settings.conditions[0].from_hz = std::nextafter(50.0F, 51.0F);
  EXPECT_EQ(validate(settings, 50.0F), SettingsError::kConditions);
}

TEST(Settings, HaveNoLastVersion) {
  EXPECT_TRUE(is_newer(1, kNoSettings));
  EXPECT_TRUE(is_newer(0xFFFFFFFFU, kNoSettings));
  EXPECT_FALSE(is_newer(kNoSettings, kNoSettings));
  EXPECT_FALSE(is_newer(kNoSettings, 0xFFFFFFFFU));
  EXPECT_EQ(next_version(0xFFFFFFFFU), 1U);
  EXPECT_EQ(next_version(kNoSettings), 1U);
  for (const std::uint32_t version : {1U, 7U, 0x80000000U, 0xFFFFFFFFU}) {
    EXPECT_TRUE(is_newer(next_version(version), version)) << version;
    EXPECT_FALSE(is_newer(version, version)) << version;
    EXPECT_FALSE(is_newer(version, next_version(version))) << version;
  }
  EXPECT_TRUE(is_newer(0x80000006U, 7U));
  EXPECT_FALSE(is_newer(0x80000007U, 7U));
}

TEST(Settings, TheFirstMayHaveAnyVersionButZero) {
  Config config;
  State state;
  ASSERT_TRUE(configure(Hardware{}, config));
  Settings settings = test::ieee24_settings();
  settings.version = kNoSettings;
  EXPECT_EQ(apply(config, state, settings), SettingsError::kStale);
  settings.version = 1;
  EXPECT_EQ(apply(config, state, settings), SettingsError::kNone);
}

// Changes each byte, so that a field that is missing from the digest is detected. Only padding may
// change without effect.
TEST(Settings, TheDigestChangesWithEveryByteOfEveryField) {
  Settings settings;
  std::memset(static_cast<void*>(&settings), 0, sizeof settings);
  settings = test::ieee24_settings();
  settings.condition_rows = kMaxConditions;
  const std::uint32_t before = digest(settings);
  auto* bytes = reinterpret_cast<unsigned char*>(&settings);
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < sizeof settings; ++i) {
    bytes[i] ^= 0x01U;
    unseen += digest(settings) == before ? 1 : 0;
    bytes[i] ^= 0x01U;
  }
  EXPECT_EQ(digest(settings), before);
  const std::size_t padding =
      offsetof(Settings, condition_hits) - offsetof(Settings, condition_rows) -
      sizeof settings.condition_rows + offsetof(Settings, event_drop_hz) -
      offsetof(Settings, event_drops) - sizeof settings.event_drops +
      offsetof(Settings, measurement_sigma_hz) - offsetof(Settings, ekf_samples) -
      sizeof settings.ekf_samples + offsetof(Settings, delay_s) -
      offsetof(Settings, decision_reports) - sizeof settings.decision_reports;
  EXPECT_EQ(unseen, padding);
}

TEST(Settings, TheDigestIgnoresUnusedRows) {
  Settings settings = test::ieee24_settings();
  const std::uint32_t before = digest(settings);
  settings.conditions[settings.condition_rows] = {1.0F, -1.0F};
  EXPECT_EQ(digest(settings), before);
}

}  // namespace
}  // namespace gs::outlet
