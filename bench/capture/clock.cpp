#include <algorithm>
#include <cmath>

#include <capture/clock.hpp>

namespace gsbench::capture {
namespace {

// Of a crystal without temperature compensation, over its range.
constexpr double kCrystalPpm = 100.0;
// The voltage is a mean over tens of milliseconds, read every 16 ms: the middle of a dip comes out
// this well at best, whatever the residuals of six of them say.
constexpr double kLeastSigmaMs = 0.05;
// A spacing or a length that differs from a marker's by more is another disturbance's.
constexpr double kToleranceMs = 20.0;

struct Seen {
  double middle_sample = 0.0;
  double length_samples = 0.0;
};

// A stretch in which V² is below the middle between marker and nominal. Its middle is that of the
// missing V², its length that over the marker's depth: both independent of how the outlet smooths.
class DipFinder {
 public:
  DipFinder(const VoltageTrace& trace, double level)
      : trace_(trace), full_depth_(1.0 - level * level) {}

  std::vector<Seen> find() const {
    std::vector<Seen> found;
    const double threshold = 1.0 - 0.5 * full_depth_;
    for (std::size_t i = 0; i < trace_.sample.size(); ++i) {
      if (square(i) >= threshold) {
        continue;
      }
      std::size_t end = i;
      while (end < trace_.sample.size() && square(end) < threshold) {
        ++end;
      }
      // What the smoothing has spread to either side belongs to it.
      if (i >= kFlank && end + kFlank <= trace_.sample.size() && end > i) {
        measure(i - kFlank, end + kFlank, found);
      }
      i = end;
    }
    return found;
  }

 private:
  static constexpr std::size_t kFlank = 5;

  double square(std::size_t i) const {
    const auto v = static_cast<double>(trace_.voltage_pu[i]);
    return v * v;
  }

  double sample(std::size_t i) const { return static_cast<double>(trace_.sample[i]); }

  void measure(std::size_t first, std::size_t end, std::vector<Seen>& found) const {
    // Undisturbed voltage on either side, as the two outermost readings have it.
    const double before = 0.5 * (square(first) + square(first + 1));
    const double after = 0.5 * (square(end - 1) + square(end - 2));
    double weight = 0.0;
    double moment = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const double part = static_cast<double>(i - first) / static_cast<double>(end - 1 - first);
      const double missing = before + part * (after - before) - square(i);
      weight += missing;
      moment += missing * (sample(i) - sample(first));
    }
    if (!(weight > 0.0)) {
      return;
    }
    const double spacing = (sample(end - 1) - sample(first)) / static_cast<double>(end - 1 - first);
    found.push_back({sample(first) + moment / weight - trace_.delay_samples,
                     weight / (0.5 * (before + after) * full_depth_) * spacing});
  }

  const VoltageTrace& trace_;
  double full_depth_;
};

double middle(const Dip& dip) {
  return 0.5 * static_cast<double>(dip.from_tick + dip.to_tick);
}

// Are seen[at], seen[at + 1], … these dips?
bool match(const std::vector<Seen>& seen, std::size_t at, const std::vector<Dip>& dips,
           double tolerance) {
  if (dips.empty() || at + dips.size() > seen.size()) {
    return false;
  }
  for (std::size_t i = 0; i < dips.size(); ++i) {
    const double length = static_cast<double>(dips[i].to_tick - dips[i].from_tick);
    const double since_first = seen[at + i].middle_sample - seen[at].middle_sample;
    const double due = middle(dips[i]) - middle(dips.front());
    if (std::fabs(seen[at + i].length_samples - length) > tolerance ||
        std::fabs(since_first - due) > tolerance) {
      return false;
    }
  }
  return true;
}

struct Point {
  double tick;
  double sample;
};

void add_points(const std::vector<Seen>& seen, std::size_t at, const std::vector<Dip>& dips,
                std::vector<Point>& points) {
  for (std::size_t i = 0; i < dips.size(); ++i) {
    points.push_back({middle(dips[i]), seen[at + i].middle_sample});
  }
}

struct Fit {
  double mean_tick = 0.0;
  double mean_sample = 0.0;
  double slope = 1.0;
  double spread = 0.0;  // Σ (tick − mean)²
};

Fit fit(const std::vector<Point>& points, bool with_slope) {
  Fit fit;
  for (const Point& p : points) {
    fit.mean_tick += p.tick / static_cast<double>(points.size());
    fit.mean_sample += p.sample / static_cast<double>(points.size());
  }
  double product = 0.0;
  for (const Point& p : points) {
    fit.spread += (p.tick - fit.mean_tick) * (p.tick - fit.mean_tick);
    product += (p.tick - fit.mean_tick) * (p.sample - fit.mean_sample);
  }
  if (with_slope) {
    fit.slope = product / fit.spread;
  }
  return fit;
}

double residual_sigma(const std::vector<Point>& points, const Fit& fit, double least) {
  double squares = 0.0;
  for (const Point& p : points) {
    const double r = p.sample - fit.mean_sample - fit.slope * (p.tick - fit.mean_tick);
    squares += r * r;
  }
  const auto freedom = std::max(1.0, static_cast<double>(points.size()) - 2.0);
  return std::max(least, std::sqrt(squares / freedom));
}

}  // namespace

std::int64_t OutletClock::tick_of(std::uint64_t sample) const {
  return std::llround((static_cast<double>(sample) - sample_at_zero_) / samples_per_tick_);
}

std::optional<Alignment> align(const VoltageTrace& trace, const Markers& markers,
                               double sample_rate_hz) {
  const std::vector<Seen> seen = DipFinder(trace, markers.level).find();
  const double tolerance = 1e-3 * kToleranceMs * sample_rate_hz;
  std::vector<Point> points;
  std::size_t at = 0;
  while (at < seen.size() && !match(seen, at, markers.before, tolerance)) {
    ++at;
  }
  if (at >= seen.size()) {
    return std::nullopt;
  }
  add_points(seen, at, markers.before, points);
  bool has_after = false;
  for (std::size_t last = seen.size(); last-- > at + markers.before.size() && !has_after;) {
    has_after = match(seen, last, markers.after, tolerance);
    if (has_after) {
      add_points(seen, last, markers.after, points);
    }
  }

  const Fit line = fit(points, has_after);
  const double sigma = residual_sigma(points, line, 1e-3 * kLeastSigmaMs * sample_rate_hz);
  // Of the run's times those farthest from the middle of all dips are known least.
  const double farthest =
      std::max(line.mean_tick - middle(markers.before.front()),
               (has_after ? middle(markers.after.back())
                          : static_cast<double>(markers.before.back().to_tick)) -
                   line.mean_tick);
  const double drift_sigma = has_after ? sigma / std::sqrt(line.spread) : 0.5e-6 * kCrystalPpm;
  const double at_worst =
      std::hypot(sigma / std::sqrt(static_cast<double>(points.size())), drift_sigma * farthest);
  Alignment alignment;
  alignment.clock = OutletClock(line.mean_sample - line.slope * line.mean_tick, line.slope);
  alignment.told.drift_ppm = 1e6 * (line.slope - 1.0);
  alignment.told.drift_uncertainty_ppm = 2e6 * drift_sigma;
  // A stamp is a whole number of samples; the true instant lies anywhere within.
  alignment.told.uncertainty_ms = 1e3 / sample_rate_hz * (2.0 * at_worst + 0.5);
  return alignment;
}

}  // namespace gsbench::capture
