#include <outlet/grid_follower.hpp>

namespace gs::outlet {
namespace {

// The windows of successive phasors (56 ms) overlap, so that their noise is correlated. Over many
// reports it averages like independent noise with 1.57 times the standard deviation.
constexpr float kOverlap = 1.57f;
// The phase noise is measured by the third differences of successive phases, in which changes of
// the grid are negligible. Their variance is kThirdDifference times that of a phase, plus that of
// the front end's images. Averaged over two seconds it varies by 15 %. Divided by kNoiseMargin, it
// replaces the setting only if it is clearly larger.
constexpr float kThirdDifference = 3.9f;
constexpr float kImages_cycles2 = 2.7e-8f;  // (1.03 mrad)²
constexpr float kNoiseMargin = 1.3f;
constexpr float kNoiseMemory = 1.0f / 128.0f;  // weight of the newest difference
constexpr float kLargestSquare = 9.0f;         // times the mean; limits the effect of a phase step
// Standard deviation of the process noise of the lost power in a report, as a part of scale_mw:
// outside an onset, and in it.
constexpr float kLossNoise = 1.4e-4f;
constexpr float kOnsetLossNoise = 0.85f;
// An onset is found if the sum of the newest n normalised innovations exceeds ± kOnsetSigmas·√n,
// for n = 4, 8 or 16.
constexpr float kOnsetSigmas = 4.5f;
constexpr int kSumLengths[] = {4, 8, 16};
constexpr int kReportsBetweenOnsets = 12;
constexpr std::uint32_t kReportsBeforeFirstOnset = 16;
// The filter goes back only if it has processed at least this many reports.
constexpr std::uint32_t kLeastHistory = 8;
// The most reports that the kOnsetMeasurements of an onset may span if there are gaps.
constexpr int kLongestOnset = 20;
constexpr int kLongestOnsetWithSwing = 9;
// Measurements before a disturbance is recognised that it may already have affected.
constexpr int kSpoiledMeasurements = 2;

// The rival has the process noise kFreePhase_cycles (1.8°) of the phase in each report of the
// onset, and in the first kFreePhaseReports after it was found. It fails if the sum or the sum of
// squares of its normalised innovations is too large; it is right after kRivalReports measurements.
constexpr int kFreePhaseReports = 4;
constexpr float kFreePhase_cycles = 0.005f;
constexpr float kRivalSumSigmas = 4.0f;
constexpr float kRivalSquaresSigmas = 4.0f;
constexpr float kRivalSquaresMargin = 6.0f;
constexpr int kRivalReports = 16;
constexpr int kCaughtUpAtOnce = 2;
constexpr int kBankReportsAtOnce = 4;

// A change of the lost power is significant if it exceeds both limits, between kSignificantReports
// and kAnnouncedWithin reports after the newest onset was found.
constexpr int kSignificantReports = 8;
constexpr float kSignificantSigmas = 6.0f;
constexpr float kSignificantPart = 0.11f;  // of scale_mw
constexpr int kAnnouncedWithin = 60;

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

constexpr float square(float x) {
  return x * x;
}

float loss_noise_mw2(const FollowerSettings& settings, float part) {
  return square(part * settings.scale_mw);
}

// Stops at the maximum.
void count_up(std::uint16_t& reports) {
  reports = static_cast<std::uint16_t>(reports < 0xFFFF ? reports + 1 : reports);
}

FollowedReport& at(GridFollower& f, std::uint32_t number) {
  return f.reports[number & (kFollowedReports - 1)];
}

// Returns the normalised innovation; 0 without a measurement, or if only the phase is taken.
float correct_by(GridFilter& filter, const PhaseMeasurement& m) {
  if (!m.measured) {
    return 0.0f;
  }
  if (m.after_gap) {
    take_phase(filter, m.phase_cycles, m.variance);
    return 0.0f;
  }
  const Innovation innovation = correct(filter, m.phase_cycles, m.variance);
  if (!filter.with_swing) {
    count(filter, innovation);
  }
  return innovation.normalised;
}

// Processes report `number`, the first time or again.
void take(const FollowerSettings& settings, GridFollower& f, std::uint32_t number) {
  if (number % (kFollowedReports / kKeptFilters) == 0) {
    f.kept[number / (kFollowedReports / kKeptFilters) % kKeptFilters] = f.filter;
  }
  FollowedReport& report = at(f, number);
  predict(settings.step, f.filter,
          {0.0f, loss_noise_mw2(settings, report.onset ? kOnsetLossNoise : kLossNoise)});
  const float innovation = correct_by(f.filter, report.measurement);
  report.innovation = report.onset ? 0.0f : innovation;
  f.next = number + 1;
}

// Restores the filter's state before report `number`, or before the nearest one whose state was
// kept. catch_up() processes the reports from there on again.
void go_back(GridFollower& f, std::uint32_t number) {
  constexpr std::uint32_t kSpacing = kFollowedReports / kKeptFilters;
  number = number > f.oldest ? number : f.oldest;
  f.next = number / kSpacing * kSpacing;
  if (f.next < f.oldest) {
    f.next += kSpacing;
  }
  f.filter = f.kept[f.next / kSpacing % kKeptFilters];
}

float nominal_phase_variance(const FollowerSettings& settings) {
  return square(settings.phase_sigma_rad / kTwoPi);
}

// Variance of a measured phase at nominal amplitude, cycles²: the larger of the setting's and the
// measured one.
float phase_variance(const FollowerSettings& settings, const GridFollower& f) {
  const float measured = (f.noise_squares - kImages_cycles2) / (kThirdDifference * kNoiseMargin);
  return square(kOverlap) * maximum(measured, nominal_phase_variance(settings));
}

// Updates noise_squares with the newest report, `now`. Requires four successive measurements.
void measure_noise(GridFollower& f, std::uint32_t now) {
  if (now < f.oldest + 3) {
    return;
  }
  for (std::uint32_t age = 0; age < 4; ++age) {
    const PhaseMeasurement& m = at(f, now - age).measurement;
    if (!m.measured || (m.after_gap && age < 3)) {
      return;
    }
  }
  const auto phase = [&](std::uint32_t age) { return at(f, now - age).measurement.phase_cycles; };
  float difference = phase(0) - phase(3) - 3.0f * (phase(1) - phase(2));
  difference -= nearest_whole(difference);
  const float limited = minimum(square(difference), kLargestSquare * f.noise_squares);
  f.noise_squares += kNoiseMemory * (limited - f.noise_squares);
}

// start_bank() continues with it. `from` is `behind` reports behind the newest one.
void restart_bank(GridFollower& f, const GridFilter& from, std::uint32_t behind) {
  f.bank.filters[0] = from;
  f.bank_behind = static_cast<std::uint8_t>(behind);
  f.bank_starts = true;
}

void begin(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m,
           float deviation_hz) {
  clear(f);
  f.noise_squares = kThirdDifference * nominal_phase_variance(settings) + kImages_cycles2;
  start(settings.response, f.filter, m.phase_cycles, deviation_hz);
  take_phase(f.filter, m.phase_cycles, m.variance);
  restart_bank(f, f.filter, 0);
}

// Another filter replaces the present one. Earlier reports cannot be processed again by it.
void continue_with(GridFollower& f, const GridFilter& filter) {
  f.filter = filter;
  f.oldest = f.count;
  f.next = f.count;
  f.rival_lives = false;
  f.announced = true;
  for (FollowedReport& report : f.reports) {
    report.innovation = 0.0f;
  }
}

bool onset_found(GridFollower& f) {
  if (f.count < kReportsBeforeFirstOnset || f.count < f.oldest + kLeastHistory ||
      f.since_onset <= kReportsBetweenOnsets) {
    return false;
  }
  float sum = 0.0f;
  int taken = 0;
  for (std::uint32_t age = 1; age < kFollowedReports; ++age) {
    const FollowedReport& report = at(f, f.count - age);
    if (!report.measurement.measured) {
      continue;
    }
    sum += report.innovation;
    ++taken;
    for (const int length : kSumLengths) {
      if (taken == length && sum * sum > square(kOnsetSigmas) * static_cast<float>(length)) {
        return true;
      }
    }
  }
  return false;
}

// Number of the onset's first report. The onset has the newest kOnsetMeasurements measurements, and
// the gap before them if there is one, within the longest span.
std::uint32_t first_of_onset(GridFollower& f) {
  const int longest = f.filter.with_swing ? kLongestOnsetWithSwing : kLongestOnset;
  int length = 0;
  int measurements = 0;
  while (length < longest && measurements < kOnsetMeasurements) {
    ++length;
    measurements +=
        at(f, f.count - static_cast<std::uint32_t>(length)).measurement.measured ? 1 : 0;
  }
  while (length < longest &&
         !at(f, f.count - static_cast<std::uint32_t>(length) - 1).measurement.measured) {
    ++length;
  }
  return f.count - static_cast<std::uint32_t>(length);
}

void start_rival(GridFollower& f) {
  f.rival = f.filter;
  f.rival_next = f.next;
  f.rival_lives = true;
  f.rival_reports = 0;
  f.rival_sum = 0.0f;
  f.rival_squares = 0.0f;
}

// The filter and the rival process at most `reports` each of those that they must process again.
void catch_up(const FollowerSettings& settings, GridFollower& f, int reports) {
  for (int i = 0; i < reports && is_behind(f); ++i) {
    take(settings, f, f.next);
  }
  for (int i = 0; i < reports && f.rival_lives && f.rival_next < f.count; ++i) {
    predict(settings.step, f.rival,
            {square(kFreePhase_cycles), loss_noise_mw2(settings, kLossNoise)});
    correct_by(f.rival, at(f, f.rival_next++).measurement);
  }
}

// Begins an onset: the last reports are processed again, with a large process noise of the lost
// power.
void open(GridFollower& f) {
  const bool settled = f.count >= f.oldest + kSettledReports;
  const std::uint32_t first = first_of_onset(f);
  go_back(f, first);
  if (!f.filter.with_swing && settled && f.since_onset > kReportsOfSwing &&
      f.filter.likelihood >= likeliest(f.bank).likelihood) {
    restart_bank(f, f.filter, f.count - f.next);
  }
  f.filter.likelihood -= kOnsetPenalty;
  if (f.announced) {
    f.loss_before_mw = f.filter.x[kLoss];
    f.announced = false;
  }
  if (!f.rival_lives && !f.changed) {
    f.loss_before_change_mw = f.filter.x[kLoss];
    f.since_change = 0;
    f.decided = false;
  }
  if (!f.rival_lives) {
    start_rival(f);
  }
  for (std::uint32_t i = first; i < f.count; ++i) {
    at(f, i).onset = true;
  }
  f.since_onset = 0;
  f.onsets = static_cast<std::uint8_t>(f.onsets < 0xFF ? f.onsets + 1 : 0xFF);
}

// The voltage is found to be disturbed: its last measurements before may be wrong.
void discard_spoiled(GridFollower& f) {
  const std::uint32_t first = f.count - 1 - kSpoiledMeasurements;
  for (std::uint32_t i = first; i < f.count; ++i) {
    at(f, i).measurement.measured = false;
  }
  go_back(f, first);
}

// Moves the bank's first filter by at most kBankReportsAtOnce of the reports that it is behind, and
// then starts the bank from it.
void start_bank(const FollowerSettings& settings, GridFollower& f) {
  for (int i = 0; i < kBankReportsAtOnce && f.bank_behind > 0; ++i) {
    predict(settings.step, f.bank.filters[0], {0.0f, loss_noise_mw2(settings, kLossNoise)});
    --f.bank_behind;
  }
  if (f.bank_behind == 0) {
    start(f.bank, f.bank_measurement);
    f.bank_starts = false;
    f.bank_next = kSwingFilters;
  }
}

// Processes the newest report by the rival. It may fail, which confirms the onset, or replace the
// filter.
void follow_rival(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m) {
  const float free_phase = f.since_onset <= kFreePhaseReports ? square(kFreePhase_cycles) : 0.0f;
  predict(settings.step, f.rival, {free_phase, loss_noise_mw2(settings, kLossNoise)});
  const float innovation = correct_by(f.rival, m);
  ++f.rival_next;
  if (!m.measured || m.after_gap) {
    return;
  }
  ++f.rival_reports;
  f.rival_sum += innovation;
  f.rival_squares += square(innovation);
  const auto n = static_cast<float>(f.rival_reports);
  const float excess = f.rival_squares - n - kRivalSquaresMargin;
  if (square(f.rival_sum) > square(kRivalSumSigmas) * n ||
      (excess > 0.0f && square(excess) > square(kRivalSquaresSigmas) * 2.0f * n)) {
    f.rival_lives = false;
    f.changed = true;
  } else if (f.rival_reports >= kRivalReports) {
    continue_with(f, f.rival);
  }
}

// True once for a change of the lost power: when it becomes significant.
bool becomes_significant(const FollowerSettings& settings, GridFollower& f) {
  if (f.announced) {
    return false;
  }
  if (f.since_onset > kAnnouncedWithin) {
    f.announced = true;
    return false;
  }
  const float change_mw = f.filter.x[kLoss] - f.loss_before_mw;
  const float least_mw = maximum(kSignificantSigmas * root(variance(f.filter, kLoss)),
                                 kSignificantPart * settings.scale_mw);
  if (f.rival_lives || f.since_onset < kSignificantReports ||
      square(change_mw) < square(least_mw)) {
    return false;
  }
  f.announced = true;
  return true;
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
    continue_with(f, *swinging);
    f.since_onset = 0;
    f.onsets = 0;
    f.since_swing = 0;
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
  measure_noise(f, now);
  take(settings, f, now);
  if (measured) {
    f.gap = 0;
  } else {
    count_up(f.gap);
  }
  count_up(f.since_onset);
  count_up(f.since_change);
  f.bank_measurement = m;
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
    open(f);
  } else if (!measured && f.gap == 1 && now >= f.oldest + kLeastHistory) {
    discard_spoiled(f);
  }
  result.significant = becomes_significant(settings, f);
  return result;
}

void follow_up(const FollowerSettings& settings, GridFollower& f, int due) {
  for (; f.parts < due; ++f.parts) {
    catch_up(settings, f, kCaughtUpAtOnce);
    if (f.bank_starts) {
      start_bank(settings, f);
    } else if (f.bank_next < kSwingFilters && !f.filter.with_swing) {
      follow(settings.step, f.bank, f.bank_next++,
             {loss_noise_mw2(settings, kLossNoise), loss_noise_mw2(settings, kOnsetLossNoise)},
             f.bank_measurement);
    }
  }
}

}  // namespace gs::outlet
