#include <outlet/crc32.hpp>
#include <outlet/event_detector.hpp>
#include <outlet/loss_ekf.hpp>
#include <outlet/loss_lse.hpp>
#include <outlet/settings.hpp>
#include <outlet/settings_fields.hpp>

namespace gs::outlet {
namespace {

bool within(float x, float low, float high) {
  return x >= low && x <= high;
}

struct AllFinite {
  bool finite = true;
  void operator()(float x) { finite = finite && within(x, -1.0e9f, 1.0e9f); }
  void operator()(std::uint32_t) {}
  void operator()(std::uint16_t) {}
  void operator()(std::uint8_t) {}
  void count(std::uint8_t, int) {}
};

// Every count as a 32-bit word, every float as its bits.
struct Digest {
  Crc32 crc;
  void operator()(float x) {
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, &x, sizeof bits);
    (*this)(bits);
  }
  void operator()(std::uint32_t word) {
    for (int byte = 0; byte < 4; ++byte) {
      crc.add(static_cast<std::uint8_t>(word >> (8 * byte)));
    }
  }
  void operator()(std::uint16_t x) { (*this)(std::uint32_t{x}); }
  void operator()(std::uint8_t x) { (*this)(std::uint32_t{x}); }
  void count(std::uint8_t rows, int) { (*this)(rows); }
};

bool response_served(const Settings& s) {
  const Response& r = s.response;
  const float omega_n2 = r.discriminant_per_s2 + r.sigma_per_s * r.sigma_per_s;
  if (!(r.gain_hz_per_mw > 0.0f) || !(r.initial_slope_per_s > 0.0f) || !(r.sigma_per_s > 0.0f) ||
      !(omega_n2 > 0.0f)) {
    return false;
  }
  const float tau_s =
      -kEarliestLossS + kReportS * static_cast<float>(s.lse_samples + s.ekf_samples);
  const float z = r.discriminant_per_s2 * tau_s * tau_s;
  return within(z, -kLargestSeriesArgument, kLargestSeriesArgument) &&
         r.sigma_per_s * tau_s <= kLargestDecay;
}

bool conditions_in_order(const Settings& s, float nominal_hz) {
  if (s.condition_rows == 0 || s.condition_rows > kMaxConditions) {
    return false;
  }
  float above = nominal_hz;
  for (int row = 0; row < s.condition_rows; ++row) {
    const ConditionRow& condition = s.conditions[row];
    if (!(condition.from_hz < above) || !(condition.from_hz > 0.0f) ||
        !(condition.rocof_below_hz_s <= 0.0f)) {
      return false;
    }
    above = condition.from_hz;
  }
  return true;
}

bool counts_in_range(const Settings& s) {
  return s.rocof_samples >= 2 && s.rocof_samples <= kHistoryLength && s.event_drops >= 1 &&
         s.event_drops < kBaselineAge && s.lse_samples >= 2 && s.lse_samples <= kMaxLseSamples &&
         s.ekf_samples >= 1 && s.ekf_samples <= 200 && s.switch_off_samples >= 1 &&
         s.switch_off_samples <= 50;
}

bool estimator_in_range(const Settings& s) {
  return within(s.measurement_sigma_hz, 1.0e-5f, 1.0f) && s.loss_sigma_mw > 0.0f &&
         s.loss_sigma_mw <= s.largest_loss_mw && within(s.event_lag_s, 0.0f, 0.1f) &&
         within(s.t_x_sigma_s, 1.0e-4f, 0.5f) && within(s.trusted_residual_hz, 1.0e-4f, 1.0f);
}

bool tracker_in_range(const TrackerSettings& t) {
  return within(t.phase_noise_rad, 1.0e-5f, 0.1f) &&
         within(t.jerk_rad_s3_per_sqrt_hz, 1.0e-3f, 1.0e3f) && within(t.leap_rad, 1.0e-3f, 3.0f) &&
         within(t.leap_amplitude, 1.0e-3f, 1.0f) && within(t.dead_bus_pu, 0.01f, 0.5f);
}

}  // namespace

const char* to_string(SettingsError error) {
  switch (error) {
    case SettingsError::kNone:
      return "accepted";
    case SettingsError::kNotFinite:
      return "a value is not finite";
    case SettingsError::kResponse:
      return "frequency response out of range";
    case SettingsError::kThreshold:
      return "threshold or largest loss out of range";
    case SettingsError::kAccumulated:
      return "accumulated power negative";
    case SettingsError::kSwitchOff:
      return "switching-off frequency not from 80 % of nominal to below nominal";
    case SettingsError::kConditions:
      return "load-shedding conditions missing, too many or not descending";
    case SettingsError::kCounts:
      return "a number of samples out of range";
    case SettingsError::kEvent:
      return "event drop or departure out of range";
    case SettingsError::kEstimator:
      return "estimator settings out of range";
    case SettingsError::kTracker:
      return "tracker settings out of range";
    case SettingsError::kStale:
      return "not newer than the settings in force";
  }
  return "unknown";
}

SettingsError validate(const Settings& s, float nominal_hz) {
  AllFinite all;
  visit_fields(s, all);
  if (!all.finite) {
    return SettingsError::kNotFinite;
  }
  if (!counts_in_range(s)) {
    return SettingsError::kCounts;
  }
  if (!response_served(s)) {
    return SettingsError::kResponse;
  }
  if (!(s.threshold_mw > 0.0f) || !(s.largest_loss_mw > 0.0f)) {
    return SettingsError::kThreshold;
  }
  if (!(s.accumulated_mw >= 0.0f)) {
    return SettingsError::kAccumulated;
  }
  if (!(s.switch_off_hz >= 0.8f * nominal_hz) || !(s.switch_off_hz < nominal_hz)) {
    return SettingsError::kSwitchOff;
  }
  if (!conditions_in_order(s, nominal_hz)) {
    return SettingsError::kConditions;
  }
  if (!within(s.event_drop_hz, 0.0f, 1.0f) || !within(s.event_departure_hz, 0.0f, 1.0f)) {
    return SettingsError::kEvent;
  }
  if (!estimator_in_range(s)) {
    return SettingsError::kEstimator;
  }
  if (!tracker_in_range(s.tracker)) {
    return SettingsError::kTracker;
  }
  return SettingsError::kNone;
}

std::uint32_t digest(const Settings& settings) {
  Digest all;
  visit_fields(settings, all);
  return all.crc.value();
}

}  // namespace gs::outlet
