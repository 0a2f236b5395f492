// Settings that the control centre sends to an outlet before any event (§3.2), and their
// validation. Units are in the names; kSettingsFields has the ranges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <outlet/event_detector.hpp>
#include <outlet/history.hpp>
#include <outlet/response.hpp>
#include <outlet/tracker.hpp>

namespace gs::outlet {

constexpr int kMaxConditions = 32;

// One row of Table 1. Its condition is met while f is at least from_hz, but below from_hz of the
// row above, and the ROCOF is below rocof_below_hz_s.
struct ConditionRow {
  float from_hz = 0.0f;
  float rocof_below_hz_s = 0.0f;
};

// Settings::method: how the outlet decides by criterion (1).
constexpr std::uint8_t kByPaper = 0;      // loss above the threshold, and load-shedding conditions
constexpr std::uint8_t kByGridState = 1;  // estimated state of the grid, and its predicted nadir

constexpr std::uint32_t kNoSettings = 0;  // version of an outlet without settings

// Whether settings with this version replace those accepted last. The version after the largest is
// 1, so that no version is the last one.
constexpr bool is_newer(std::uint32_t version, std::uint32_t accepted) {
  return version != kNoSettings &&
         (accepted == kNoSettings || version - accepted - 1 < 0x7FFFFFFFu);
}
constexpr std::uint32_t next_version(std::uint32_t accepted) {
  return accepted + 1 == kNoSettings ? 1 : accepted + 1;
}

struct Settings {
  std::uint32_t version = kNoSettings;  // the control centre counts its sets of settings from 1

  // The system, for the ΔP estimate.
  Response response;
  float threshold_mw = 0.0f;     // ΔP_s, eq. (15)
  float largest_loss_mw = 0.0f;  // bound of the estimate: the system's generation

  // For decisions by the grid's state (`method` below).
  float threshold_hz = 0.0f;       // f_s: lowest permitted nadir
  float nadir_margin_hz = 0.003f;  // the predicted nadir is kept this far above f_s

  // This outlet's place in the order of shedding.
  float accumulated_mw = 0.0f;  // P^A, eq. (11)
  float switch_off_hz = 0.0f;   // f^B, eq. (17)

  // Load-shedding conditions, from f_n down.
  ConditionRow conditions[kMaxConditions];
  std::uint8_t condition_rows = 0;
  // n_max of §5.2. A hit is a report that meets a condition. The outlet sheds only with more hits
  // than this in the ekf_samples reports. A loss at the threshold has 25 ± 3 hits, a loss of 320 MW
  // has 14 ± 3, and a loss of 380 MW has 33 ± 3.
  std::uint16_t condition_hits = 20;
  std::uint8_t rocof_samples = 8;  // measurements in the least-squares slope

  // Event detection, §5.1: number of successive drops, their least sum, and the least fall below
  // the baseline. The paper's rule is the number of drops alone; see event_detector.hpp.
  std::uint8_t event_drops = 5;
  float event_drop_hz = 0.014f;
  float event_departure_hz = 0.018f;

  std::uint8_t lse_samples = 10;
  std::uint8_t ekf_samples = 40;
  float measurement_sigma_hz = 0.005f;
  float loss_sigma_mw = 0.0f;  // of the LSE that starts the EKF
  // The EKF's initial t_x lies event_lag_s before the event's first drop, because the loss occurs
  // within a report and noise can hide the first drop. t_x_sigma_s is its standard deviation. With
  // noise of 1 % on the voltage, an event is detected 7 ms later than its drops take, with a spread
  // of 11 ms.
  float event_lag_s = 0.008f;
  float t_x_sigma_s = 0.010f;
  float trusted_residual_hz = 0.015f;  // RMS of the EKF's innovations above which ΔP is not trusted

  // The outlet switches off after this many successive measurements below f^B. They are few enough
  // for "immediately", and enough to ignore a glitch.
  std::uint8_t switch_off_samples = 3;

  std::uint8_t method = kByGridState;
  // From the report in which an onset was found to the decision by the grid's state, if the
  // estimate is sure by then; at most 20 reports more.
  std::uint8_t decision_reports = 40;

  // Time delay of the relay (§3.1), for criteria (1) and (2). Restoration: an outlet that switched
  // off by itself switches on again after f has been at least restore_hz without interruption, for
  // restore_dwell_s plus a random part of restore_spread_s.
  float delay_s = 0.0f;
  float restore_hz = 0.0f;  // 0: only by command
  float restore_dwell_s = 60.0f;
  float restore_spread_s = 300.0f;

  TrackerSettings tracker;
};

enum class SettingsError : std::uint8_t {
  kNone = 0,
  kUnknownField = 1,  // sent by a centre of a later version
  // Gain, slope or omega_n² not positive, or beyond the limits of the model's series.
  kResponse = 2,
  kThreshold = 3,
  kAccumulated = 4,
  kSwitchOff = 5,   // below 80 % of nominal, or above nominal
  kConditions = 6,  // no row, too many, not descending, or a limit above zero
  kCounts = 7,      // number of samples out of range
  kEvent = 8,       // drop or departure not within 0 … 1 Hz
  kEstimator = 9,
  kTracker = 10,
  kStale = 11,   // version not newer than that of the settings accepted last
  kMethod = 12,  // method, threshold frequency or margin out of range
  kRelay = 13,   // delay or restoration out of range
};

constexpr SettingsError kLastSettingsError = SettingsError::kRelay;

const char* to_string(SettingsError error);

// Returns kNone, or the error of the first field that is out of range, or of fields that do not fit
// together. It does not check whether the version is newer: apply() does, with kStale.
SettingsError validate(const Settings& settings, float nominal_hz);

// CRC-32 (IEEE 802.3) over every field in order, little-endian. The outlet acknowledges settings
// with it.
std::uint32_t digest(const Settings& settings);

// kSettingsFields lists all settings with name, unit and range. Validation, digest, wire format,
// the profile's keys and the record's entries are derived from it. To add a setting, add a member
// to Settings and a line to the list.

// Magnitude limit of every setting, in its own unit.
constexpr float kLargestSetting = 1.0e9f;

struct Range {
  float least = 0.0f;
  float most = kLargestSetting;
  bool without_least = false;  // open interval: `least` itself is excluded
  bool without_most = false;
  bool of_nominal = false;  // the ends are fractions of the nominal frequency
};

constexpr Range from_to(float least, float most) {
  return {least, most};
}
constexpr Range kAbove0 = {0.0f, kLargestSetting, true};
constexpr Range kSwitchOffRange = {0.8f, 1.0f, false, false, true};

enum class FieldType : std::uint8_t { kU8, kU16, kU32, kFloat, kRows };

struct Field {
  const char* name;  // with the unit
  const char* unit;  // empty for counts
  std::uint8_t key;  // on the wire; never reused for another field
  FieldType type;
  std::uint16_t offset;  // in Settings
  Range range;           // compared in single precision, as the firmware does
  SettingsError error;   // if out of range
  // For settings that profiles may set: the meaning, and a text on the value without the key.
  const char* meaning = nullptr;
  const char* otherwise = nullptr;  // nullptr: the default of Settings
};

template <class T>
constexpr FieldType type_of(const T&) {
  static_assert(std::is_array_v<T> || std::is_same_v<T, float> ||
                (std::is_unsigned_v<T> && sizeof(T) <= sizeof(std::uint32_t)));
  return std::is_array_v<T>            ? FieldType::kRows
         : std::is_floating_point_v<T> ? FieldType::kFloat
         : sizeof(T) == 1              ? FieldType::kU8
         : sizeof(T) == 2              ? FieldType::kU16
                                       : FieldType::kU32;
}

// Type and offset of a member.
#define GS_SETTING(member) type_of(Settings{}.member), offsetof(Settings, member)

inline constexpr Field kSettingsFields[] = {
    {"version", "", 1, GS_SETTING(version), {0.0f, 4294967295.0f}, SettingsError::kStale},
    {"gain_hz_per_mw", "Hz/MW", 2, GS_SETTING(response.gain_hz_per_mw), kAbove0,
     SettingsError::kResponse},
    {"sigma_per_s", "1/s", 3, GS_SETTING(response.sigma_per_s), kAbove0, SettingsError::kResponse},
    {"discriminant_per_s2", "1/s²", 4, GS_SETTING(response.discriminant_per_s2),
     from_to(-kLargestSetting, kLargestSetting), SettingsError::kResponse},
    {"initial_slope_per_s", "1/s", 5, GS_SETTING(response.initial_slope_per_s), kAbove0,
     SettingsError::kResponse},
    {"threshold_mw", "MW", 6, GS_SETTING(threshold_mw), kAbove0, SettingsError::kThreshold,
     "ΔP_s: threshold loss, the largest that needs no shedding", "by `rules`"},
    {"largest_loss_mw", "MW", 7, GS_SETTING(largest_loss_mw), kAbove0, SettingsError::kThreshold},
    {"accumulated_mw", "MW", 8, GS_SETTING(accumulated_mw), from_to(0.0f, kLargestSetting),
     SettingsError::kAccumulated},
    {"switch_off_hz", "Hz", 9, GS_SETTING(switch_off_hz), kSwitchOffRange,
     SettingsError::kSwitchOff, "f^B: switching-off frequency", "by `rules`"},
    {"conditions", "Hz, Hz/s", 10, GS_SETTING(conditions), {}, SettingsError::kConditions},
    {"condition_hits", "", 11, GS_SETTING(condition_hits), from_to(0.0f, 1000.0f),
     SettingsError::kCounts,
     "n_max: hits of the load-shedding condition that must be exceeded before shedding"},
    {"rocof_samples", "", 12, GS_SETTING(rocof_samples), from_to(2.0f, kHistoryLength),
     SettingsError::kCounts},
    {"event_drops", "", 13, GS_SETTING(event_drops), from_to(1.0f, kBaselineAge - 1),
     SettingsError::kCounts},
    {"event_drop_hz", "Hz", 14, GS_SETTING(event_drop_hz), from_to(0.0f, 1.0f),
     SettingsError::kEvent, "minimum sum of five consecutive drops for an event"},
    {"event_departure_hz", "Hz", 15, GS_SETTING(event_departure_hz), from_to(0.0f, 1.0f),
     SettingsError::kEvent, "minimum distance below the baseline for an event"},
    {"lse_samples", "", 16, GS_SETTING(lse_samples), from_to(2.0f, kMaxLseSamples),
     SettingsError::kCounts, "number of measurements in the least-squares estimate, eq. (19)"},
    {"ekf_samples", "", 17, GS_SETTING(ekf_samples), from_to(1.0f, 200.0f), SettingsError::kCounts,
     "number of measurements in the EKF after those of the LSE"},
    {"measurement_sigma_hz", "Hz", 18, GS_SETTING(measurement_sigma_hz), from_to(1.0e-5f, 1.0f),
     SettingsError::kEstimator},
    {"loss_sigma_mw", "MW", 19, GS_SETTING(loss_sigma_mw), kAbove0, SettingsError::kEstimator},
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
    {"method", "", 29, GS_SETTING(method), from_to(0.0f, 1.0f), SettingsError::kMethod,
     "how the outlet decides: 1 by the grid's state and predicted nadir, 0 as the paper does"},
    {"threshold_hz", "Hz", 30, GS_SETTING(threshold_hz), kSwitchOffRange, SettingsError::kMethod,
     "f_s: threshold frequency, which the nadir must not fall below", "the grid's"},
    {"nadir_margin_hz", "Hz", 31, GS_SETTING(nadir_margin_hz), from_to(0.0f, 0.1f),
     SettingsError::kMethod, "margin of the predicted nadir above f_s"},
    {"decision_reports", "", 32, GS_SETTING(decision_reports), from_to(8.0f, 200.0f),
     SettingsError::kCounts, "reports of 16 ms from the onset of a change to the decision"},
    {"delay_s", "s", 33, GS_SETTING(delay_s), from_to(0.0f, 5.0f), SettingsError::kRelay,
     "time from the decision to switch off, or from f^B, to the opening of the relay"},
    {"restore_hz", "Hz", 34, GS_SETTING(restore_hz), from_to(0.0f, 70.0f), SettingsError::kRelay,
     "frequency above which the outlet switches on again by itself; 0: only by command"},
    {"restore_dwell_s", "s", 35, GS_SETTING(restore_dwell_s), from_to(0.0f, 3600.0f),
     SettingsError::kRelay, "time for which the frequency must stay above restore_hz"},
    {"restore_spread_s", "s", 36, GS_SETTING(restore_spread_s), from_to(0.0f, 3600.0f),
     SettingsError::kRelay, "longest random time that is added to restore_dwell_s"},
};
#undef GS_SETTING

// Ranges of a row of conditions.
constexpr Range kRowFrequency = {0.0f, 1.0f, true, false, true};
constexpr Range kRowRocof = {-kLargestSetting, 0.0f};

// Whether the value is in the range. nominal_hz scales ranges that are of_nominal. NaN is outside
// of every range.
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

// `S` is Settings or const Settings. Calls visit(field, member), or for the conditions
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
