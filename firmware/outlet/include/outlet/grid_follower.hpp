// Estimates the state of the grid in every report: frequency, lost power and its standard
// deviation. It continues through successive losses, ramps, returns of power, load shed by others,
// disturbances of the voltage and an inter-area oscillation.
//
// The filter assumes that the lost power is nearly constant. An onset is the report in which its
// innovations show that this is wrong. The filter then goes back by seven measurements, and up to
// three reports more, and processes them again with a large process noise of the lost power. That
// work is spread over the time to the next report.
//
// A phase step of the voltage causes an onset, too. A rival filter therefore processes the same
// measurements with a large process noise of the phase instead. If its innovations fit for sixteen
// measurements (a quarter of a second), only the phase has changed, and the rival replaces the
// filter. If they do not, the onset is confirmed.
//
// An oscillation causes onsets, too. The bank starts at the first of them. The follower continues
// with one of its filters if that is clearly likelier.
#pragma once

#include <outlet/swing_bank.hpp>

namespace gs::outlet {

constexpr int kFollowedReports = 32;  // a power of two
constexpr int kKeptFilters = 8;
constexpr int kReportsPerKept = kFollowedReports / kKeptFilters;

struct FollowerSettings {
  Response response;
  GridStep step;          // grid_step(response, kReport_s)
  float scale_mw = 0.0f;  // > 0: the threshold loss; scale of the process noise of the lost power
  // Standard deviation of a measured phase at nominal amplitude. A noise that is measured to be
  // clearly larger replaces it.
  float phase_sigma_rad = 0.0f;
};

struct FollowedReport {
  PhaseMeasurement measurement;
  float innovation = 0.0f;  // in its standard deviations; 0 without one, or in an onset
  bool onset = false;       // processed with the large process noise of the lost power
};

// Reports are numbered from 0 at the start. gap, since_onset, since_change and onsets
// stop at the maximum of their types.
struct GridFollower {
  GridFilter filter;                         // after the newest report
  FollowedReport reports[kFollowedReports];  // ring: report n at n % kFollowedReports
  // Ring: the filter before report n, at n / kReportsPerKept % kKeptFilters.
  GridFilter kept[kKeptFilters];
  std::uint32_t count = 0;     // reports since the start; number of the next one
  std::uint32_t oldest = 0;    // number of the first report that `filter` has processed
  std::uint32_t next = 0;      // number of its next report; see is_behind()
  std::uint16_t gap = 0;       // successive newest reports without a measurement
  float noise_squares = 0.0f;  // running mean of the phases' squared third differences, cycles²
  std::uint16_t since_onset = 0xFFFF;  // reports since the newest onset was found
  // Reports since the first onset of a change that is not decided completely, or since the newest
  // decision on it.
  std::uint16_t since_change = 0xFFFF;
  float loss_before_mw = 0.0f;  // lost power before the change that began with an onset
  // Lost power before the first onset of the newest change, MW.
  float loss_before_change_mw = 0.0f;

  // The rival: only the phase has changed.
  GridFilter rival;
  std::uint32_t rival_next = 0;    // number of its next report; behind `count` after an onset
  bool rival_lives = false;        // it has neither failed nor replaced `filter`
  std::uint8_t rival_reports = 0;  // its measurements since the onset was found
  float rival_sum = 0.0f;          // of its normalised innovations in these
  float rival_squares = 0.0f;      // of the squares of these innovations

  bool decided = false;   // a decision was made on the newest change; set by the outlet
  bool changed = false;   // an onset is confirmed; the outlet clears it with the last decision
  bool announced = true;  // no change waits to be reported as Followed::significant

  // For follow_up().
  std::uint8_t parts = 0;  // that are done since the newest report
  SwingBank bank;
  std::uint8_t bank_next = kSwingFilters;  // index of its next filter; kSwingFilters: all are done
  bool bank_starts = false;                // the bank is to be started from its first filter,
  std::uint8_t bank_behind = 0;            // which is as many reports behind the newest one

  // While `filter` has an oscillation: onsets since the present period of 6.4 s began.
  std::uint8_t onsets = 0;
  std::uint16_t since_swing = 0;  // with an oscillation: reports since it was added, modulo 2¹⁶
};

// Forgets everything; the next measurement starts the follower, and that starts the bank's filters.
// It sets field by field, because a temporary GridFollower would not fit onto an outlet's stack.
void clear(GridFollower& follower);

struct Followed {
  bool valid = false;  // false until the first measurement
  GridState state;     // at the time of the report's phasor, kFrontEndDelay_s ago
  float loss_sigma_mw = 0.0f;
  bool significant = false;  // true once, when a change of the lost power has become significant
};

// Takes one report of 16 ms.
//   phase_cycles  of the phasor, relative to nominal; whole cycles do not matter
//   amplitude     of the phasor, per unit of the nominal amplitude, > 0
//   measured      false: the voltage is disturbed, and phase and amplitude are ignored
//   deviation_hz  of the tracker's frequency from nominal; used only where the follower or the bank
//                 starts
Followed follow(const FollowerSettings& settings, GridFollower& follower, float phase_cycles,
                float amplitude, bool measured, float deviation_hz);

// True if reports are to be processed again, since an onset or a disturbance was found in the
// newest one. Followed::state of that report does not take account of it yet.
inline bool is_behind(const GridFollower& follower) {
  return follower.next < follower.count;
}

// Work that is spread over the time between two reports, in kReportParts parts: the filters of the
// bank, and reports that are to be processed again. Does what is left of the first `due` parts, 0 …
// kReportParts. The next follow() does what is left then.
constexpr int kReportParts = 16;
void follow_up(const FollowerSettings& settings, GridFollower& follower, int due);

}  // namespace gs::outlet
