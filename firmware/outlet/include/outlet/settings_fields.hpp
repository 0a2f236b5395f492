// The settings as one list of name, unit, range and value. Validation, digest, wire, what a profile
// may set and what a record keeps are derived from it: a new setting is a member of Settings and a
// line here.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/event_detector.hpp>
#include <outlet/history.hpp>
#include <outlet/loss_lse.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

// Beyond this no setting makes sense, whatever its unit.
constexpr float kLargestSetting = 1.0e9f;

struct Range {
  float least = 0.0f;
  float most = kLargestSetting;
  bool without_least = false;  // above it, not at it
  bool without_most = false;
  bool of_nominal = false;  // the ends are parts of the nominal frequency
};

constexpr Range from_to(float least, float most) {
  return {least, most};
}
constexpr Range above_0_to(float most) {
  return {0.0f, most, true};
}

enum class FieldType : std::uint8_t { kU8, kU16, kU32, kFloat, kRows };

struct Field {
  const char* name;  // with the unit
  const char* unit;  // empty where it is a number of something
  std::uint8_t key;  // on the wire; never given to another field
  FieldType type;
  std::uint16_t offset;  // in Settings
  Range range;           // of a float the firmware's single precision decides
  SettingsError error;   // where it is out of its range
};

constexpr FieldType type_of(std::uint8_t) {
  return FieldType::kU8;
}
constexpr FieldType type_of(std::uint16_t) {
  return FieldType::kU16;
}
constexpr FieldType type_of(std::uint32_t) {
  return FieldType::kU32;
}
constexpr FieldType type_of(float) {
  return FieldType::kFloat;
}
constexpr FieldType type_of(const ConditionRow*) {
  return FieldType::kRows;
}

// The one place where a member is named: its type and where it stands.
#define GS_SETTING(member) type_of(Settings{}.member), offsetof(Settings, member)

inline constexpr Field kSettingsFields[] = {
    {"version", "", 1, GS_SETTING(version), {0.0f, 4294967295.0f}, SettingsError::kStale},
    {"gain_hz_per_mw", "Hz/MW", 2, GS_SETTING(response.gain_hz_per_mw), above_0_to(kLargestSetting),
     SettingsError::kResponse},
    {"sigma_per_s", "1/s", 3, GS_SETTING(response.sigma_per_s), above_0_to(kLargestSetting),
     SettingsError::kResponse},
    {"discriminant_per_s2", "1/s²", 4, GS_SETTING(response.discriminant_per_s2),
     from_to(-kLargestSetting, kLargestSetting), SettingsError::kResponse},
    {"initial_slope_per_s", "1/s", 5, GS_SETTING(response.initial_slope_per_s),
     above_0_to(kLargestSetting), SettingsError::kResponse},
    {"threshold_mw", "MW", 6, GS_SETTING(threshold_mw), above_0_to(kLargestSetting),
     SettingsError::kThreshold},
    {"largest_loss_mw", "MW", 7, GS_SETTING(largest_loss_mw), above_0_to(kLargestSetting),
     SettingsError::kThreshold},
    {"accumulated_mw", "MW", 8, GS_SETTING(accumulated_mw), from_to(0.0f, kLargestSetting),
     SettingsError::kAccumulated},
    {"switch_off_hz",
     "Hz",
     9,
     GS_SETTING(switch_off_hz),
     {0.8f, 1.0f, false, true, true},
     SettingsError::kSwitchOff},
    {"conditions", "Hz, Hz/s", 10, GS_SETTING(conditions), {}, SettingsError::kConditions},
    {"condition_hits", "", 11, GS_SETTING(condition_hits), from_to(0.0f, 1000.0f),
     SettingsError::kCounts},
    {"rocof_samples", "", 12, GS_SETTING(rocof_samples), from_to(2.0f, kHistoryLength),
     SettingsError::kCounts},
    {"event_drops", "", 13, GS_SETTING(event_drops), from_to(1.0f, kBaselineAge - 1),
     SettingsError::kCounts},
    {"event_drop_hz", "Hz", 14, GS_SETTING(event_drop_hz), from_to(0.0f, 1.0f),
     SettingsError::kEvent},
    {"event_departure_hz", "Hz", 15, GS_SETTING(event_departure_hz), from_to(0.0f, 1.0f),
     SettingsError::kEvent},
    {"lse_samples", "", 16, GS_SETTING(lse_samples), from_to(2.0f, kMaxLseSamples),
     SettingsError::kCounts},
    {"ekf_samples", "", 17, GS_SETTING(ekf_samples), from_to(1.0f, 200.0f), SettingsError::kCounts},
    {"measurement_sigma_hz", "Hz", 18, GS_SETTING(measurement_sigma_hz), from_to(1.0e-5f, 1.0f),
     SettingsError::kEstimator},
    {"loss_sigma_mw", "MW", 19, GS_SETTING(loss_sigma_mw), above_0_to(kLargestSetting),
     SettingsError::kEstimator},
    {"event_lag_s", "s", 20, GS_SETTING(event_lag_s), from_to(0.0f, 0.1f),
     SettingsError::kEstimator},
    {"t_x_sigma_s", "s", 21, GS_SETTING(t_x_sigma_s), from_to(1.0e-4f, 0.5f),
     SettingsError::kEstimator},
    {"trusted_residual_hz", "Hz", 22, GS_SETTING(trusted_residual_hz), from_to(1.0e-4f, 1.0f),
     SettingsError::kEstimator},
    {"switch_off_samples", "", 23, GS_SETTING(switch_off_samples), from_to(1.0f, 50.0f),
     SettingsError::kCounts},
    {"phase_noise_rad", "rad", 24, GS_SETTING(tracker.phase_noise_rad), from_to(1.0e-5f, 0.1f),
     SettingsError::kTracker},
    {"jerk_rad_s3_per_sqrt_hz", "rad/s³/√Hz", 25, GS_SETTING(tracker.jerk_rad_s3_per_sqrt_hz),
     from_to(1.0e-3f, 1.0e3f), SettingsError::kTracker},
    {"innovation_gate_rad", "rad", 26, GS_SETTING(tracker.innovation_gate_rad),
     from_to(1.0e-3f, 3.0f), SettingsError::kTracker},
    {"innovation_gate_amplitude", "pu", 27, GS_SETTING(tracker.innovation_gate_amplitude),
     from_to(1.0e-3f, 1.0f), SettingsError::kTracker},
    {"dead_bus_pu", "pu", 28, GS_SETTING(tracker.dead_bus_pu), from_to(0.01f, 0.5f),
     SettingsError::kTracker},
};
#undef GS_SETTING

// Of a row of conditions: below the one above, and at most.
constexpr Range kRowFrequency = {0.0f, 1.0f, true, true, true};
constexpr Range kRowRocof = {-kLargestSetting, 0.0f};

// nominal_hz scales what is of_nominal. NaN is in no range.
constexpr bool within(const Range& range, float value, float nominal_hz) {
  const float scale = range.of_nominal ? nominal_hz : 1.0f;
  return (range.without_least ? value > range.least * scale : value >= range.least * scale) &&
         (range.without_most ? value < range.most * scale : value <= range.most * scale);
}

template <class T>
T& member(Settings& s, const Field& field) {
  return *reinterpret_cast<T*>(reinterpret_cast<unsigned char*>(&s) + field.offset);
}
template <class T>
const T& member(const Settings& s, const Field& field) {
  return *reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(&s) + field.offset);
}

// `S` is Settings or const Settings. Calls visit(field, its member), or for the conditions
// visit.rows(field, s.conditions, s.condition_rows).
template <class S, class Visitor>
void visit_field(S& s, const Field& field, Visitor& visit) {
  switch (field.type) {
    case FieldType::kU8:
      return visit(field, member<std::uint8_t>(s, field));
    case FieldType::kU16:
      return visit(field, member<std::uint16_t>(s, field));
    case FieldType::kU32:
      return visit(field, member<std::uint32_t>(s, field));
    case FieldType::kFloat:
      return visit(field, member<float>(s, field));
    case FieldType::kRows:
      return visit.rows(field, s.conditions, s.condition_rows);
  }
}

template <class S, class Visitor>
void visit_fields(S& s, Visitor& visit) {
  for (const Field& field : kSettingsFields) {
    visit_field(s, field, visit);
  }
}

}  // namespace gs::outlet
