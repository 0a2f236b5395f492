#include "dips.hpp"

#include <cmath>

namespace gsbench::capture {
namespace {

// Tolerance of the spacing and the length of a marker dip; beyond it, a dip is another disturbance.
// Readings come every 16 ms, and one or two at an edge may be lost.
constexpr double kTolerance_ms = 20.0;

struct FoundDip {
  double middle_sample = 0.0;
  double length_samples = 0.0;
};

// Intervals in which V² is below edge_square().
std::vector<FoundDip> find_dips(const VoltageTrace& trace, double level) {
  const double threshold = edge_square(level);
  const auto square = [&](std::size_t i) {
    const auto volts = static_cast<double>(trace.voltage_pu[i]);
    return volts * volts;
  };
  // Sample of the crossing between readings i − 1 and i.
  const auto crossing = [&](std::size_t i) {
    const auto from = static_cast<double>(trace.sample[i - 1]);
    const auto to = static_cast<double>(trace.sample[i]);
    return from + (to - from) * (threshold - square(i - 1)) / (square(i) - square(i - 1));
  };
  std::vector<FoundDip> found;
  double began = 0.0;
  bool in_dip = false;
  for (std::size_t i = 1; i < trace.sample.size(); ++i) {
    const bool was_below = square(i - 1) < threshold;
    const bool below = square(i) < threshold;
    if (below && !was_below) {
      began = crossing(i);
      in_dip = true;
    } else if (was_below && !below && in_dip) {
      const double ended = crossing(i);
      found.push_back({0.5 * (began + ended - trace.window_samples), ended - began});
    }
  }
  return found;
}

double middle(const Dip& dip) {
  return 0.5 * static_cast<double>(dip.from_tick + dip.to_tick);
}

// True if seen[at], seen[at + 1], … match `dips` in length and spacing.
bool match(const std::vector<FoundDip>& seen, std::size_t at, const std::vector<Dip>& dips,
           double tolerance) {
  if (dips.empty() || at + dips.size() > seen.size()) {
    return false;
  }
  for (std::size_t i = 0; i < dips.size(); ++i) {
    const double length = static_cast<double>(dips[i].to_tick - dips[i].from_tick);
    const double since_first = seen[at + i].middle_sample - seen[at].middle_sample;
    const double expected = middle(dips[i]) - middle(dips.front());
    if (!(std::fabs(seen[at + i].length_samples - length) <= tolerance) ||
        !(std::fabs(since_first - expected) <= tolerance)) {
      return false;
    }
  }
  return true;
}

void add(const std::vector<FoundDip>& seen, std::size_t at, const std::vector<Dip>& dips,
         FoundMarkers& all) {
  for (std::size_t i = 0; i < dips.size(); ++i) {
    all.markers.push_back({middle(dips[i]), seen[at + i].middle_sample});
  }
}

}  // namespace

double edge_square(double level) {
  return 0.5 * (1.0 + level * level);
}

FoundMarkers find_markers(const VoltageTrace& trace, const Markers& markers,
                          double sample_rate_hz) {
  const std::vector<FoundDip> seen = find_dips(trace, markers.level);
  const double tolerance = 1e-3 * kTolerance_ms * sample_rate_hz;
  FoundMarkers all;
  std::size_t at = 0;
  while (at < seen.size() && !match(seen, at, markers.before.dips, tolerance)) {
    ++at;
  }
  if (at >= seen.size()) {
    return all;
  }
  add(seen, at, markers.before.dips, all);
  // The last match, since dips of the run itself come before the markers.
  for (std::size_t last = seen.size(); last-- > at + markers.before.dips.size() && !all.after;) {
    all.after = match(seen, last, markers.after.dips, tolerance);
    if (all.after) {
      add(seen, last, markers.after.dips, all);
    }
  }
  return all;
}

}  // namespace gsbench::capture
