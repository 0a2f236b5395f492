#include "followed_reports.hpp"
#include "onset.hpp"
#include "phase_noise.hpp"

#include <outlet/grid_follower.hpp>

namespace gs::outlet {
namespace {

// The bank restarts after 8 s without an oscillation. It also restarts at an onset, since an
// oscillation may begin there, unless one has been going on: the previous onset is less than
// kReportsOfSwing ago, or a filter of the bank is likelier than the one without an oscillation. The
// state before the onset must have settled for kSettledReports.
constexpr std::uint16_t kBankReports = 500;
constexpr std::uint16_t kReportsOfSwing = 60;
constexpr std::uint32_t kSettledReports = 50;
// The oscillation is given up below this amplitude, or if this many onsets are found in one period
// of kSwingOnsetReports.
constexpr float kSwingEnds_hz = 0.006f;
constexpr std::uint8_t kOnsetsThatEndSwing = 6;
constexpr std::uint16_t kSwingOnsetReports = 400;

// Work in each part of follow_up(): reports to process again, for the filter and for the rival; and
// reports by which the filter that the bank starts from is moved.
constexpr int kCaughtUpAtOnce = 2;
constexpr int kBankReportsAtOnce = 4;
static_assert(kReportParts * kCaughtUpAtOnce >= kMostBehind);

// start_bank() continues with it. `from` is `behind` reports behind the newest one.
void restart_bank(GridFollower& f, const GridFilter& from, std::uint32_t behind) {
  f.bank.filters[0] = from;
  f.bank_behind = static_cast<std::uint8_t>(behind);
  f.bank_starts = true;
}

void begin(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m,
           float deviation_hz) {
  clear(f);
  f.noise_squares = nominal_noise_squares(settings);
  start(settings.response, f.filter, m.phase_cycles, deviation_hz);
  take_phase(f.filter, m);
  restart_bank(f, f.filter, 0);
}

// Switches between filters with and without an oscillation, before report m is processed. The bank
// has processed all earlier reports.
void choose_swing(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m,
                  float deviation_hz) {
  ++f.since_swing;
  if (f.filter.with_swing) {
    if (f.since_swing % kSwingOnsetReports == 0) {
      f.onsets = 0;
    }
    if (swing_hz(f.filter) < kSwingEnds_hz || f.onsets >= kOnsetsThatEndSwing) {
      begin(settings, f, m, deviation_hz);
    }
    return;
  }
  if (const GridFilter* const swinging = established(f.bank, f.filter.likelihood)) {
    // An onset that is not confirmed yet may be a loss, which the bank's filters have found, too.
    f.changed = f.changed || f.rival_lives;
    continue_with(f, *swinging);
    f.since_onset = 0;
    f.onsets = 0;
    f.since_swing = 0;
  }
}

// An onset: looks for an oscillation, and for another lost power or phase.
void begin_onset(GridFollower& f) {
  const bool settled = f.count >= f.oldest + kSettledReports;
  const bool may_swing = settled && f.since_onset > kReportsOfSwing && !f.filter.with_swing;
  open(f);
  if (may_swing && f.filter.likelihood >= likeliest(f.bank).likelihood) {
    restart_bank(f, f.filter, f.count - f.next);
  }
  f.filter.likelihood -= kOnsetPenalty;
}

// Moves the bank's first filter by at most kBankReportsAtOnce of the reports that it is behind, and
// then starts the bank from it.
void start_bank(const FollowerSettings& settings, GridFollower& f) {
  for (int i = 0; i < kBankReportsAtOnce && f.bank_behind > 0; ++i) {
    predict(settings.step, f.bank.filters[0], {0.0f, loss_noise_mw2(settings, kLossNoise)});
    --f.bank_behind;
  }
  if (f.bank_behind == 0) {
    start(f.bank, at(f, f.count - 1).measurement);
    f.bank_starts = false;
    f.bank_next = kSwingFilters;
  }
}

}  // namespace

void clear(GridFollower& f) {
  f.filter = GridFilter{};
  f.rival = GridFilter{};
  for (FollowedReport& report : f.reports) {
    report = FollowedReport{};
  }
  f.count = 0;
  f.next = 0;
  f.oldest = 0;
  f.gap = 0;
  f.noise_squares = 0.0f;
  f.since_onset = 0xFFFF;
  f.since_change = 0xFFFF;
  f.loss_before_mw = 0.0f;
  f.loss_before_change_mw = 0.0f;
  f.rival_lives = false;
  f.rival_next = 0;
  f.rival_reports = 0;
  f.rival_sum = 0.0f;
  f.rival_squares = 0.0f;
  f.changed = false;
  f.decided = false;
  f.announced = true;
  f.parts = 0;
  f.bank.age = 0;
  f.bank_next = kSwingFilters;
  f.bank_starts = false;
  f.bank_behind = 0;
  f.onsets = 0;
  f.since_swing = 0;
}

Followed follow(const FollowerSettings& settings, GridFollower& f, float phase_cycles,
                float amplitude, bool measured, float deviation_hz) {
  PhaseMeasurement m;
  m.phase_cycles = phase_cycles;
  // The same noise rotates a shorter phasor by a larger angle.
  m.variance = phase_variance(settings, f) / square(minimum(amplitude, 1.0f));
  m.measured = measured;
  m.after_gap = measured && f.gap > 0;
  if (f.count == 0 && !measured) {
    return {};
  }
  follow_up(settings, f, kReportParts);
  f.parts = 0;
  if (f.count == 0) {
    begin(settings, f, m, deviation_hz);
  } else {
    choose_swing(settings, f, m, deviation_hz);
  }
  const std::uint32_t now = f.count++;
  at(f, now) = FollowedReport{};
  at(f, now).measurement = m;
  measure_noise(f);
  take(settings, f, now);
  if (measured) {
    f.gap = 0;
  } else {
    count_up(f.gap);
  }
  count_up(f.since_onset);
  count_up(f.since_change);
  f.bank_next = 0;
  if (measured && f.bank.age >= kBankReports && !f.filter.with_swing) {
    GridFilter steady;
    start(settings.response, steady, phase_cycles, deviation_hz);
    steady.likelihood = f.filter.likelihood;
    restart_bank(f, steady, 0);
  }
  if (f.rival_lives) {
    follow_rival(settings, f, m);
  }
  Followed result;
  result.valid = true;
  result.state = {f.filter.x[kDeviation], f.filter.x[kUnloadedRocof], f.filter.x[kLoss]};
  result.loss_sigma_mw = root(variance(f.filter, kLoss));
  if (measured && onset_found(f)) {
    begin_onset(f);
  } else if (!measured && f.gap == 1) {
    discard_spoiled(f);
  }
  result.significant = becomes_significant(settings, f);
  return result;
}

void follow_up(const FollowerSettings& settings, GridFollower& f, int due) {
  for (; f.parts < due; ++f.parts) {
    for (int i = 0; i < kCaughtUpAtOnce && is_behind(f); ++i) {
      take(settings, f, f.next);
    }
    catch_up_rival(settings, f, kCaughtUpAtOnce);
    if (f.bank_starts) {
      start_bank(settings, f);
    } else if (f.bank_next < kSwingFilters && !f.filter.with_swing) {
      follow(settings.step, f.bank, f.bank_next++,
             {loss_noise_mw2(settings, kLossNoise), loss_noise_mw2(settings, kOnsetLossNoise)},
             at(f, f.count - 1).measurement);
    }
  }
}

}  // namespace gs::outlet
