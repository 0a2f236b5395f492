#include "host_clock.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::head {
namespace {

// With fewer points, the rates of the two clocks are not compared but taken as nominal.
constexpr std::size_t kPointsOfALine = 5;
constexpr double kHost_ppm = 100.0;  // accuracy of this machine's clock, ±

}  // namespace

HostClockEstimate::HostClockEstimate(double clock_ppm) : ppm_(clock_ppm + kHost_ppm) {}

void HostClockEstimate::add(double head_s, Clock::time_point arrival) {
  if (!origin_) {
    origin_ = arrival;
  }
  const Point point{head_s, std::chrono::duration<double>(arrival - *origin_).count() - head_s};
  const auto second = static_cast<std::int64_t>(std::floor(head_s));
  if (earliest_.empty() || second != second_) {
    earliest_.push_back(point);
    second_ = second;
  } else if (point.late_s < earliest_.back().late_s) {
    earliest_.back() = point;
  }
}

HostClockEstimate::Line HostClockEstimate::line_through_points(double tick_0_s,
                                                               double end_s) const {
  if (earliest_.size() < kPointsOfALine) {
    const Point& best =
        *std::min_element(earliest_.begin(), earliest_.end(),
                          [](const Point& a, const Point& b) { return a.late_s < b.late_s; });
    const double farthest_s =
        std::max(std::fabs(tick_0_s - best.head_s), std::fabs(end_s - best.head_s));
    return {best.late_s, 0.0, 1e-6 * ppm_ * farthest_s};
  }
  double middle_s = 0.0;
  double middle_late_s = 0.0;
  for (const Point& point : earliest_) {
    middle_s += point.head_s / static_cast<double>(earliest_.size());
    middle_late_s += point.late_s / static_cast<double>(earliest_.size());
  }
  double products = 0.0;
  double squares = 0.0;
  for (const Point& point : earliest_) {
    products += (point.head_s - middle_s) * (point.late_s - middle_late_s);
    squares += (point.head_s - middle_s) * (point.head_s - middle_s);
  }
  const double slope = products / squares;
  const double late_at_0_s = middle_late_s - slope * middle_s;
  double residual_s = 0.0;
  for (const Point& point : earliest_) {
    residual_s = std::max(residual_s, std::fabs(point.late_s - late_at_0_s - slope * point.head_s));
  }
  // Beyond the points, the line may deviate by what its slope allows.
  const double first_s = earliest_.front().head_s;
  const double last_s = earliest_.back().head_s;
  const double beyond_s = std::max({0.0, first_s - tick_0_s, end_s - last_s});
  return {late_at_0_s, slope, residual_s * (1.0 + 2.0 * beyond_s / (last_s - first_s))};
}

std::optional<source::HostClock> HostClockEstimate::of_ticks(double tick_0_s, double end_s,
                                                             double tick_s,
                                                             double shortest_delay_s) const {
  if (earliest_.empty()) {
    return std::nullopt;
  }
  const Line line = line_through_points(tick_0_s, end_s);
  const double tick_0_host_s =
      tick_0_s * (1.0 + line.slope) + line.late_at_0_s - 0.5 * shortest_delay_s;
  source::HostClock clock;
  clock.tick_0 = *origin_ + std::chrono::duration_cast<Clock::duration>(
                                std::chrono::duration<double>(tick_0_host_s));
  clock.tick_s = tick_s * (1.0 + line.slope);
  clock.uncertainty_s = line.uncertainty_s + 0.5 * shortest_delay_s;
  return clock;
}

}  // namespace gsbench::head
