#include "followed_reports.hpp"

namespace gs::outlet {

void take(const FollowerSettings& settings, GridFollower& f, std::uint32_t number) {
  if (number % kReportsPerKept == 0) {
    f.kept[number / kReportsPerKept % kKeptFilters] = f.filter;
  }
  FollowedReport& report = at(f, number);
  predict(settings.step, f.filter,
          {0.0f, loss_noise_mw2(settings, report.onset ? kOnsetLossNoise : kLossNoise)});
  const float innovation = correct(f.filter, report.measurement);
  report.innovation = report.onset ? 0.0f : innovation;
  f.next = number + 1;
}

void go_back(GridFollower& f, std::uint32_t number) {
  number = number > f.oldest ? number : f.oldest;
  f.next = number / kReportsPerKept * kReportsPerKept;
  if (f.next < f.oldest) {
    f.next += kReportsPerKept;
  }
  f.filter = f.kept[f.next / kReportsPerKept % kKeptFilters];
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
