#include <algorithm>
#include <cmath>

#include <fleet/clairvoyant.hpp>

namespace gsbench::fleet {
namespace {

// Of the interval from 0 to the most that may be shed. Below a millionth of a megawatt for any
// grid.
constexpr int kHalvings = 50;

}  // namespace

double least_shed_mw(const grid::SfrModel& model, const GridState& state, double goal_hz,
                     double available_mw) {
  const double most_mw = std::min(state.power_mw, available_mw);
  const auto nadir_hz = [&](double shed_mw) {
    return lowest_deviation_hz(model, with_power(model, state, state.power_mw - shed_mw));
  };
  if (most_mw <= 0.0 || nadir_hz(0.0) >= goal_hz) {
    return 0.0;
  }
  const double reach_hz = std::min(goal_hz, nadir_hz(most_mw) - kWithinBest_hz);
  if (nadir_hz(0.0) >= reach_hz) {
    return 0.0;
  }
  double little_mw = 0.0;
  double enough_mw = most_mw;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_mw = 0.5 * (little_mw + enough_mw);
    (nadir_hz(middle_mw) < reach_hz ? little_mw : enough_mw) = middle_mw;
  }
  return enough_mw;
}

double lost_mw(const std::vector<grid::PowerChange>& losses, double t_s) {
  double lost_mw = 0.0;
  for (const grid::PowerChange& change : losses) {
    lost_mw += change.at_s <= t_s ? change.changed_mw(t_s - change.at_s) : 0.0;
  }
  return lost_mw;
}

double known_loss_mw(const std::vector<grid::PowerChange>& losses, double t_s, double delay_s) {
  double least_mw = std::min(lost_mw(losses, t_s - delay_s), lost_mw(losses, t_s));
  // Between the starts and ends of changes, the lost power is linear; it may jump at a start.
  for (const grid::PowerChange& change : losses) {
    for (const double at_s : {change.at_s, change.at_s + change.ramp_s}) {
      if (at_s > t_s - delay_s && at_s <= t_s) {
        const double before_s = std::nextafter(at_s, t_s - delay_s);
        least_mw = std::min({least_mw, lost_mw(losses, before_s), lost_mw(losses, at_s)});
      }
    }
  }
  return least_mw;
}

}  // namespace gsbench::fleet
