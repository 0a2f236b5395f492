#include "followed_reports.hpp"

namespace gs::outlet {

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

void go_back(GridFollower& f, std::uint32_t number) {
  constexpr std::uint32_t kSpacing = kFollowedReports / kKeptFilters;
  number = number > f.oldest ? number : f.oldest;
  f.next = number / kSpacing * kSpacing;
  if (f.next < f.oldest) {
    f.next += kSpacing;
  }
  f.filter = f.kept[f.next / kSpacing % kKeptFilters];
}

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

}  // namespace gs::outlet
