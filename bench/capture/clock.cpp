#include "dips.hpp"

#include <algorithm>
#include <cmath>

#include <capture/clock.hpp>

namespace gsbench::capture {
namespace {

// Tolerance of a crystal without temperature compensation, over its temperature range.
constexpr double kCrystal_ppm = 100.0;
// Lower limit of the residuals: readings without noise still have rounding errors.
constexpr double kLeastSigma = 1e-4;
constexpr int kIterations = 8;
constexpr std::size_t kFewestReadings = 6;

// Squared RMS of the played voltage over the window that the outlet uses, in p.u. of nominal: 1 for
// steady mains.
class PlayedSquare {
 public:
  PlayedSquare(const MarkedStretch& stretch, double window_ticks)
      : stretch_(stretch), window_ticks_(window_ticks) {}

  bool covers(double tick) const {
    const double last = first() + static_cast<double>(stretch_.square_sum.size()) - 2.0;
    return tick - window_ticks_ >= first() && tick <= last;
  }
  double at(double tick) const {
    return 2.0 / window_ticks_ * (sum_until(tick) - sum_until(tick - window_ticks_));
  }
  double slope_at(double tick) const {
    return 2.0 / window_ticks_ * (square_at(tick) - square_at(tick - window_ticks_));
  }
  // True if the window contains exactly one edge of a dip: the RMS value is changing.
  bool in_flank(double tick) const {
    return std::any_of(stretch_.dips.begin(), stretch_.dips.end(), [&](const Dip& dip) {
      const auto holds = [&](std::int64_t edge) {
        const auto at = static_cast<double>(edge);
        return tick - window_ticks_ < at && at < tick;
      };
      return holds(dip.from_tick) != holds(dip.to_tick);
    });
  }

 private:
  double first() const { return static_cast<double>(stretch_.first_tick); }
  double square_at(double tick) const {
    const auto i = static_cast<std::size_t>(tick - first());
    return stretch_.square_sum[i + 1] - stretch_.square_sum[i];
  }
  double sum_until(double tick) const {
    const auto i = static_cast<std::size_t>(tick - first());
    return stretch_.square_sum[i] + (tick - first() - static_cast<double>(i)) * square_at(tick);
  }

  const MarkedStretch& stretch_;
  double window_ticks_;
};

// tick = tick_at_centre + ticks_per_sample · (sample − centre_sample)
struct Line {
  double centre_sample = 0.0;
  double tick_at_centre = 0.0;
  double ticks_per_sample = 1.0;

  double tick(double sample) const {
    return tick_at_centre + ticks_per_sample * (sample - centre_sample);
  }
};

Line through(const std::vector<FoundMarker>& seen, bool with_slope) {
  Line line;
  for (const FoundMarker& marker : seen) {
    line.centre_sample += marker.sample / static_cast<double>(seen.size());
    line.tick_at_centre += marker.tick / static_cast<double>(seen.size());
  }
  double product = 0.0;
  double spread = 0.0;
  for (const FoundMarker& marker : seen) {
    const double from_centre = marker.sample - line.centre_sample;
    product += from_centre * (marker.tick - line.tick_at_centre);
    spread += from_centre * from_centre;
  }
  line.ticks_per_sample = with_slope ? product / spread : 1.0;
  return line;
}

// Normal equations of the line's two parameters.
struct Normal {
  double tick_tick = 0.0;
  double tick_slope = 0.0;
  double slope_slope = 0.0;
  double tick_right = 0.0;
  double slope_right = 0.0;
  double squares = 0.0;
  std::size_t readings = 0;

  double determinant() const { return tick_tick * slope_slope - tick_slope * tick_slope; }
};

// Variances of tick_at_centre and ticks_per_sample.
struct Covariance {
  double tick = 0.0;
  double both = 0.0;
  double slope = 0.0;

  double sigma_at(double from_centre) const {
    return std::sqrt(tick + 2.0 * both * from_centre + slope * from_centre * from_centre);
  }
};

class Fit {
 public:
  Fit(const VoltageTrace& trace, const Markers& markers, const Line& start, bool with_slope)
      : trace_(trace),
        parts_{PlayedSquare(markers.before, trace.window_samples),
               PlayedSquare(markers.after, trace.window_samples)},
        line_(start),
        with_slope_(with_slope) {}

  // False if there are too few readings.
  bool solve() {
    for (int i = 0; i < kIterations; ++i) {
      const Normal n = sum_up();
      if (n.readings < kFewestReadings || !(n.tick_tick > 0.0)) {
        return false;
      }
      if (with_slope_) {
        line_.tick_at_centre +=
            (n.slope_slope * n.tick_right - n.tick_slope * n.slope_right) / n.determinant();
        line_.ticks_per_sample +=
            (n.tick_tick * n.slope_right - n.tick_slope * n.tick_right) / n.determinant();
      } else {
        line_.tick_at_centre += n.tick_right / n.tick_tick;
      }
    }
    return true;
  }

  const Line& line() const { return line_; }

  Covariance covariance() const {
    const Normal n = sum_up();
    const double parameters = with_slope_ ? 3.0 : 2.0;  // and the gain
    const double sigma2 = std::max(kLeastSigma * kLeastSigma,
                                   n.squares / (static_cast<double>(n.readings) - parameters));
    // The windows of adjacent readings overlap, so their noise is correlated: all readings within
    // one window count as one.
    const double variance = sigma2 * std::max(1.0, trace_.window_samples / spacing());
    if (with_slope_) {
      return {variance * n.slope_slope / n.determinant(),
              -variance * n.tick_slope / n.determinant(), variance * n.tick_tick / n.determinant()};
    }
    const double slope_sigma = 0.5e-6 * kCrystal_ppm;
    return {variance / n.tick_tick, 0.0, slope_sigma * slope_sigma};
  }

 private:
  // Of readings, also if some were lost or are not near an edge: the median.
  double spacing() const {
    std::vector<std::int64_t> spacings;
    for (std::size_t i = 1; i < trace_.sample.size(); ++i) {
      spacings.push_back(trace_.sample[i] - trace_.sample[i - 1]);
    }
    const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return static_cast<double>(*middle);
  }

  template <class Visit>
  void visit_flanks(Visit visit) const {
    for (std::size_t i = 0; i < trace_.sample.size(); ++i) {
      const auto sample = static_cast<double>(trace_.sample[i]);
      const double tick = line_.tick(sample);
      for (const PlayedSquare& played : parts_) {
        if (played.covers(tick) && played.in_flank(tick)) {
          const auto volts = static_cast<double>(trace_.voltage_pu[i]);
          visit(sample, volts * volts, played.at(tick), played.slope_at(tick));
        }
      }
    }
  }

  Normal sum_up() const {
    // Gain error of the outlet.
    double product = 0.0;
    double square = 0.0;
    visit_flanks([&](double, double seen, double played, double) {
      product += seen * played;
      square += played * played;
    });
    const double gain = product / square;
    Normal n;
    visit_flanks([&](double sample, double seen, double played, double slope) {
      const double from_centre = sample - line_.centre_sample;
      const double residual = seen / gain - played;
      n.tick_tick += slope * slope;
      n.tick_slope += slope * slope * from_centre;
      n.slope_slope += slope * slope * from_centre * from_centre;
      n.tick_right += slope * residual;
      n.slope_right += slope * residual * from_centre;
      n.squares += residual * residual;
      ++n.readings;
    });
    return n;
  }

  const VoltageTrace& trace_;
  PlayedSquare parts_[2];
  Line line_;
  bool with_slope_;
};

}  // namespace

std::optional<record::Clock> align(const VoltageTrace& trace, const Markers& markers,
                                   double sample_rate_hz) {
  const FoundMarkers found = find_markers(trace, markers, sample_rate_hz);
  if (found.markers.empty()) {
    return std::nullopt;
  }
  Fit fit(trace, markers, through(found.markers, found.after), found.after);
  if (!fit.solve()) {
    return std::nullopt;
  }
  const Line& line = fit.line();
  const Covariance covariance = fit.covariance();
  // The uncertainty is largest at the start or at the end of the run.
  const double samples_per_tick = 1.0 / line.ticks_per_sample;
  const double to_start = -line.tick_at_centre * samples_per_tick;
  const double to_end =
      found.after
          ? (static_cast<double>(markers.after.first_tick) - line.tick_at_centre) * samples_per_tick
          : static_cast<double>(trace.sample.back()) - line.centre_sample;
  const double at_worst = std::max(covariance.sigma_at(to_start), covariance.sigma_at(to_end));
  record::Clock clock;
  clock.sample_at_zero = line.centre_sample + to_start;
  clock.samples_per_tick = samples_per_tick;
  clock.drift_ppm = 1e6 * (samples_per_tick - 1.0);
  clock.drift_uncertainty_ppm = 2e6 * std::sqrt(covariance.slope);
  // Stamps are rounded to whole ticks: up to half a tick of error.
  clock.uncertainty_ms = 1e3 / sample_rate_hz * (2.0 * at_worst + 0.5);
  return clock;
}

}  // namespace gsbench::capture
