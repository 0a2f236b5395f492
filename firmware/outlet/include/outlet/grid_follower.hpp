// Follows the grid from report to report: frequency, lost power, and its standard deviation,
// whatever happens: losses one after another, ramps, returns, load shed by others, disturbances of
// the voltage, an oscillation beneath.
//
// The filter takes the lost power as constant. When its innovations show that this is wrong, an
// onset, the last reports are taken once more, with the lost power free to change in them. Whether
// the phase alone has changed is the rival explanation: a second filter follows with the phase free
// instead. If it fits for a quarter of a second, it is right, and nothing was lost.
#pragma once

#include <outlet/swing_bank.hpp>

namespace gs::outlet {

constexpr int kFollowedReports = 32;  // a power of two
constexpr int kKeptFilters = 8;       // one for each four reports

struct FollowerSettings {
  Response response;
  GridStep step;          // over 16 ms
  float scale_mw = 0.0f;  // typical lost power: the threshold loss
  float phase_sigma_rad = 0.0f;
};

struct FollowedReport {
  PhaseMeasurement measurement;
  float innovation = 0.0f;  // normalised
  bool onset = false;       // the lost power was free to change
};

struct GridFollower {
  GridFilter filter;
  FollowedReport reports[kFollowedReports];
  GridFilter kept[kKeptFilters];  // before each fourth report
  std::uint32_t count = 0;        // reports since the start
  std::uint32_t oldest = 0;       // the first report that can be taken once more
  std::uint16_t gap = 0;          // reports since the last measurement
  float noise_squares = 0.0f;     // mean of the phases' squared third differences, cycles²
  std::uint16_t since_onset = 0xFFFF;
  float loss_before_mw = 0.0f;  // at the onset

  // The rival explanation.
  GridFilter rival;
  bool rival_lives = false;
  std::uint8_t rival_reports = 0;
  float rival_sum = 0.0f;      // of its normalised innovations
  float rival_squares = 0.0f;  // of their squares

  bool changed = false;   // an onset is confirmed, and not yet taken by the outlet
  bool announced = true;  // the change of the lost power is significant and was reported

  SwingBank bank;
  PhaseMeasurement bank_measurement;
  std::uint8_t bank_next = kSwingFilters;  // the filter that is moved next
  std::uint8_t onsets = 0;  // since the bank's start; with an oscillation: in the last 6 s
  std::uint16_t since_swing = 0;
};

// Forgets everything: the next measurement starts it. Field by field: a temporary GridFollower
// would not fit onto an outlet's stack.
void clear(GridFollower& follower);

struct Followed {
  bool valid = false;
  GridState state;  // at the time of the report's phasor, kFrontEndDelay_s ago
  float loss_sigma_mw = 0.0f;
  bool significant = false;  // now: the lost power has changed significantly
};

// One report of 16 ms. `phase_cycles` and `amplitude` (per unit) of the phasor; `measured`: the
// voltage is not disturbed; `deviation_hz`: the tracker's, used at the start only.
Followed follow(const FollowerSettings& settings, GridFollower& follower, float phase_cycles,
                float amplitude, bool measured, float deviation_hz);

// Moves up to `filters` of the bank, which must all be moved before the next report.
void follow_swing(const FollowerSettings& settings, GridFollower& follower, int filters);

}  // namespace gs::outlet
