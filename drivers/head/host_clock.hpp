// The head's clock on this machine's steady clock, from the times at which statuses arrive. A
// status arrives late, never early: of each second, the one with the shortest delay counts.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include <source/source.hpp>

namespace gsbench::head {

class HostClockEstimate {
 public:
  using Clock = std::chrono::steady_clock;

  // `clock_ppm`: accuracy of the head's clock, ±.
  explicit HostClockEstimate(double clock_ppm);

  // A status that the head sent at `head_s` on its own clock, ascending.
  void add(double head_s, Clock::time_point arrival);

  // The clock of ticks from tick 0, at `tick_0_s` of the head's clock, to the end of the stimulus.
  // `shortest_delay_s`: upper bound of the shortest delay of a status. None before the first
  // status.
  std::optional<source::HostClock> of_ticks(double tick_0_s, double end_s, double tick_s,
                                            double shortest_delay_s) const;

 private:
  struct Point {
    double head_s;
    double late_s;  // arrival on this machine's clock less head_s
  };
  struct Line {
    double late_at_0_s;
    double slope;
    double uncertainty_s;  // from tick 0 to the end of the stimulus
  };
  Line line_through_points(double tick_0_s, double end_s) const;

  double ppm_;
  std::optional<Clock::time_point> origin_;
  std::vector<Point> earliest_;  // of each second
  std::int64_t second_ = 0;      // of the newest point
};

}  // namespace gsbench::head
