#include "excess_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsbench::waveform {
namespace {

// Coefficients of p(u) − p(0), u = 0 … 1, from values, slopes and curvatures at both ends.
struct End {
  double value, slope, curvature;
};

std::array<double, 5> quintic(const End& from, const End& to) {
  const double value = to.value - from.value - from.slope - 0.5 * from.curvature;
  const double slope = to.slope - from.slope - from.curvature;
  const double curvature = to.curvature - from.curvature;
  return {from.slope, 0.5 * from.curvature, 10.0 * value - 4.0 * slope + 0.5 * curvature,
          -15.0 * value + 7.0 * slope - curvature, 6.0 * value - 3.0 * slope + 0.5 * curvature};
}

}  // namespace

ExcessPhase::ExcessPhase(const ReferenceSignal& reference, std::int64_t sample_rate_hz)
    : reference_(reference), sample_rate_hz_(static_cast<double>(sample_rate_hz)) {
  for (const double t_s : reference.corners_s()) {
    const double position = t_s * sample_rate_hz_;
    if (!corners_.empty() && corners_.back().position == position) {
      corners_.back().last_s = t_s;
    } else {
      corners_.push_back({position, t_s, t_s});
    }
  }
}

ExcessPhase::Edge ExcessPhase::edge_at(const Corner& corner) const {
  const double t_s = corner.position / sample_rate_hz_;
  // The corner is between the two, whether its position was rounded up or down.
  const double before_s =
      std::nextafter(std::min(t_s, corner.first_s), -std::numeric_limits<double>::infinity());
  return {corner.position, t_s, before_s, std::max(t_s, corner.last_s)};
}

ExcessPhase::Edge ExcessPhase::edge_at(std::int64_t tick) const {
  const auto position = static_cast<double>(tick);
  const auto corner =
      std::lower_bound(corners_.begin(), corners_.end(), position,
                       [](const Corner& candidate, double at) { return candidate.position < at; });
  if (corner != corners_.end() && corner->position == position) {
    return edge_at(*corner);
  }
  const double t_s = position / sample_rate_hz_;
  return {position, t_s, t_s, t_s};
}

ExcessPhase::Edge ExcessPhase::next_edge(const Edge& edge, std::int64_t block_end_tick) const {
  const auto corner =
      std::upper_bound(corners_.begin(), corners_.end(), edge.position,
                       [](double at, const Corner& candidate) { return at < candidate.position; });
  if (corner != corners_.end() && corner->position < static_cast<double>(block_end_tick)) {
    return edge_at(*corner);
  }
  return edge_at(block_end_tick);
}

SmoothPiece ExcessPhase::piece(const Edge& from, const Edge& to) const {
  const double length = to.position - from.position;
  const double span_s = length / sample_rate_hz_;
  const double nominal_hz = reference_.nominal_hz();
  const double cycles_from = reference_.excess_cycles(from.t_s);
  const End start = {0.0, span_s * (reference_.frequency_hz(from.after_s) - nominal_hz),
                     span_s * span_s * reference_.rocof_hz_s(from.after_s)};
  const End end = {reference_.excess_cycles(to.t_s) - cycles_from,
                   span_s * (reference_.frequency_hz(to.before_s) - nominal_hz),
                   span_s * span_s * reference_.rocof_hz_s(to.before_s)};
  const double voltage_pu = reference_.voltage_pu(from.t_s);
  return {from.position,
          length,
          cycles_from,
          cycles_from - std::floor(cycles_from),
          quintic(start, end),
          voltage_pu,
          reference_.voltage_pu(to.t_s) - voltage_pu};
}

}  // namespace gsbench::waveform
