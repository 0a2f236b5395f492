// What the control centre sends an outlet before any event (§3.2), and what keeps nonsense out.
#pragma once

#include <cstdint>

#include <outlet/response.hpp>
#include <outlet/tracker.hpp>

namespace gs::outlet {

constexpr int kMaxConditions = 32;

// One row of Table 1: met while f is in [from_hz, the row above's from_hz) and ROCOF < the limit.
struct ConditionRow {
  float from_hz = 0.0f;
  float rocof_below_hz_s = 0.0f;
};

constexpr std::uint32_t kNoSettings = 0;  // the version of an outlet that has none

struct Settings {
  std::uint32_t version = kNoSettings;  // counts up from 1 with each set the control centre issues

  // The system, for the ΔP estimate.
  Response response;
  float threshold_mw = 0.0f;     // ΔP_s, eq. (15)
  float largest_loss_mw = 0.0f;  // beyond it no estimate is believed: the system's generation

  // This outlet's place in the order of shedding.
  float accumulated_mw = 0.0f;  // P^A, eq. (11)
  float switch_off_hz = 0.0f;   // f^B, eq. (17)

  // Load-shedding conditions, from f_n down.
  ConditionRow conditions[kMaxConditions];
  std::uint8_t condition_rows = 0;
  // n_max of §5.2: shed only with more hits than this, of the ekf_samples reports that count. A
  // loss at the threshold comes to 25 ± 3, one of 320 MW to 14 ± 3, one of 380 MW to 33 ± 3.
  std::uint16_t condition_hits = 20;
  std::uint8_t rocof_samples = 8;  // measurements in the least-squares slope

  // Event detection, §5.1: so many successive drops, this much in sum, and so far below the course
  // before. The paper's rule is the first alone; see event_detector.hpp.
  std::uint8_t event_drops = 5;
  float event_drop_hz = 0.014f;
  float event_departure_hz = 0.018f;

  std::uint8_t lse_samples = 10;
  std::uint8_t ekf_samples = 40;
  float measurement_sigma_hz = 0.005f;
  float loss_sigma_mw = 0.0f;  // of the LSE that starts the EKF
  // Where the EKF starts for t_x: so long before the event's drops, since the loss falls within a
  // report and noise hides the first drop; and how far off that is. At 1 % noise on the voltage the
  // event comes 7 ms later than its drops take, with a spread of 11 ms.
  float event_lag_s = 0.008f;
  float t_x_sigma_s = 0.010f;
  float trusted_residual_hz = 0.015f;  // RMS of the EKF's innovations above which ΔP is not trusted

  std::uint8_t switch_off_samples =
      3;  // successive measurements below f^B: "immediately", yet no glitch

  TrackerSettings tracker;
};

enum class SettingsError : std::uint8_t {
  kNone = 0,
  kUnknownField = 1,  // sent by a centre of a later version
  kResponse = 2,  // gain, slope or omega_n² not positive, or outside what the model's series carry
  kThreshold = 3,
  kAccumulated = 4,
  kSwitchOff = 5,   // below 80 % of nominal, or not below nominal
  kConditions = 6,  // no row, too many, not descending, or a limit above zero
  kCounts = 7,      // a number of samples out of range
  kEvent = 8,       // drop or departure not within 0 … 1 Hz

  kEstimator = 9,
  kTracker = 10,
  kStale = 11,  // version not above the one in force
};

const char* to_string(SettingsError error);

SettingsError validate(const Settings& settings, float nominal_hz);

// CRC-32 (IEEE 802.3) over every field in order, little-endian: what an outlet acknowledges.
std::uint32_t digest(const Settings& settings);

}  // namespace gs::outlet
