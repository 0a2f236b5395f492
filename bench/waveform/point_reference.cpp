#include "monotone_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {
namespace {

void check(const recording::TracePoint& point, const recording::TracePoint* before,
           std::size_t number) {
  const auto refuse = [number](const char* what, double value, const char* wanted) {
    throw std::invalid_argument(fmt::format("point {}: {} is {} {}", number, what, value, wanted));
  };
  if (!std::isfinite(point.t_s)) {
    refuse("time", point.t_s, "s; it must be finite");
  }
  if (before != nullptr && point.t_s <= before->t_s) {
    refuse("time", point.t_s, "s; it must be later than the previous point");
  }
  if (!std::isfinite(point.frequency_hz) || point.frequency_hz <= 0.0) {
    refuse("frequency", point.frequency_hz, "Hz; it must be finite and above 0");
  }
  if (!std::isfinite(point.voltage_pu) || point.voltage_pu < 0.0) {
    refuse("voltage", point.voltage_pu, "p.u.; it must be finite and at least 0");
  }
}

void check(double nominal_hz, const std::vector<recording::TracePoint>& points) {
  if (!std::isfinite(nominal_hz) || nominal_hz <= 0.0) {
    throw std::invalid_argument(
        fmt::format("nominal frequency is {} Hz; it must be finite and above 0", nominal_hz));
  }
  if (points.empty()) {
    throw std::invalid_argument("no frequency points; at least one is needed");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    check(points[i], i == 0 ? nullptr : &points[i - 1], i + 1);
  }
}

std::vector<Knot> deviations(double nominal_hz, const std::vector<recording::TracePoint>& points) {
  std::vector<Knot> knots;
  knots.reserve(points.size());
  for (const recording::TracePoint& point : points) {
    knots.push_back({point.t_s, point.frequency_hz - nominal_hz});
  }
  return knots;
}

class PointReference final : public ReferenceSignal {
 public:
  PointReference(double nominal_hz, std::vector<recording::TracePoint> points)
      : nominal_hz_(nominal_hz),
        points_(std::move(points)),
        deviation_hz_(deviations(nominal_hz, points_)),
        cycles_at_zero_(deviation_hz_.integral(0.0)) {}

  double nominal_hz() const override { return nominal_hz_; }
  double frequency_hz(double t_s) const override { return nominal_hz_ + deviation_hz_.value(t_s); }
  double rocof_hz_s(double t_s) const override { return deviation_hz_.slope(t_s); }
  double excess_cycles(double t_s) const override {
    return deviation_hz_.integral(t_s) - cycles_at_zero_;
  }

  double voltage_pu(double t_s) const override {
    const auto next =
        std::upper_bound(points_.begin(), points_.end(), t_s,
                         [](double t, const recording::TracePoint& p) { return t < p.t_s; });
    if (next == points_.begin()) {
      return points_.front().voltage_pu;
    }
    if (next == points_.end()) {
      return points_.back().voltage_pu;
    }
    const recording::TracePoint& from = *std::prev(next);
    const double fraction = (t_s - from.t_s) / (next->t_s - from.t_s);
    return from.voltage_pu + fraction * (next->voltage_pu - from.voltage_pu);
  }

  // The second derivative of the cubic is discontinuous at each point.
  std::vector<double> corners_s() const override {
    std::vector<double> corners;
    corners.reserve(points_.size());
    for (const recording::TracePoint& point : points_) {
      corners.push_back(point.t_s);
    }
    return corners;
  }

 private:
  double nominal_hz_;
  std::vector<recording::TracePoint> points_;
  MonotoneCubic deviation_hz_;  // from nominal, so that the integral stays small
  double cycles_at_zero_;
};

}  // namespace

std::unique_ptr<ReferenceSignal> reference_from_points(double nominal_hz,
                                                       std::vector<recording::TracePoint> points) {
  check(nominal_hz, points);
  return std::make_unique<PointReference>(nominal_hz, std::move(points));
}

}  // namespace gsbench::waveform
