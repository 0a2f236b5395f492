#include "onset.hpp"

#include "followed_reports.hpp"

namespace gs::outlet {
namespace {

// An onset is found if the sum of the newest n normalised innovations exceeds ± kOnsetSigmas·√n,
// for n = 4, 8 or 16.
constexpr float kOnsetSigmas = 4.5f;
constexpr int kSumLengths[] = {4, 8, 16};
constexpr int kReportsBetweenOnsets = 12;
constexpr std::uint32_t kReportsBeforeFirstOnset = 16;
// The filter goes back only if it has processed at least this many reports.
constexpr std::uint32_t kLeastHistory = 8;
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

// A change of the lost power is significant if it exceeds both limits, between kSignificantReports
// and kAnnouncedWithin reports after the newest onset was found.
constexpr int kSignificantReports = 8;
constexpr float kSignificantSigmas = 6.0f;
constexpr float kSignificantPart = 0.11f;  // of scale_mw
constexpr int kAnnouncedWithin = 60;

// Number of the onset's first report. The onset has the newest kOnsetMeasurements measurements, and
// the gap before them if there is one, within kLongestOnset reports.
std::uint32_t first_of_onset(GridFollower& f) {
  int length = 0;
  int measurements = 0;
  while (length < kLongestOnset && measurements < kOnsetMeasurements) {
    ++length;
    measurements +=
        at(f, f.count - static_cast<std::uint32_t>(length)).measurement.measured ? 1 : 0;
  }
  while (length < kLongestOnset &&
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

}  // namespace

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

void open(GridFollower& f) {
  const std::uint32_t first = first_of_onset(f);
  go_back(f, first);
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

void discard_spoiled(GridFollower& f) {
  if (f.count <= f.oldest + kLeastHistory) {
    return;
  }
  const std::uint32_t first = f.count - 1 - kSpoiledMeasurements;
  for (std::uint32_t i = first; i < f.count; ++i) {
    at(f, i).measurement.measured = false;
  }
  go_back(f, first);
}

void catch_up_rival(const FollowerSettings& settings, GridFollower& f, int reports) {
  for (int i = 0; i < reports && f.rival_lives && f.rival_next < f.count; ++i) {
    const FollowedReport& report = at(f, f.rival_next++);
    predict(
        settings.step, f.rival,
        {report.onset ? square(kFreePhase_cycles) : 0.0f, loss_noise_mw2(settings, kLossNoise)});
    correct(f.rival, report.measurement);
  }
}

void follow_rival(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m) {
  const float free_phase = f.since_onset <= kFreePhaseReports ? square(kFreePhase_cycles) : 0.0f;
  predict(settings.step, f.rival, {free_phase, loss_noise_mw2(settings, kLossNoise)});
  const float innovation = correct(f.rival, m);
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

}  // namespace gs::outlet
