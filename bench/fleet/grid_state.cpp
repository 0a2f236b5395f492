#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <fleet/grid_state.hpp>

namespace gsbench::fleet {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

// The first time after now at which the deviation is stationary. With z the distance from the final
// value, z' is zero where S/C = z'(0)/(omega_n²·z(0) + sigma·z'(0)), and S/C is tan(√d·t)/√d, t or
// tanh(√−d·t)/√−d.
double stationary_s(const grid::SfrModel& model, double distance_hz, double slope_hz_s) {
  const double bend =
      model.omega_n() * model.omega_n() * distance_hz + model.sigma_per_s() * slope_hz_s;
  const double d = model.discriminant_per_s2();
  if (d > 0.0) {
    const double omega_r = std::sqrt(d);
    const double angle = std::atan2(omega_r * slope_hz_s, bend);
    return (angle > 0.0 ? angle : angle + kPi) / omega_r;
  }
  const double ratio_s = slope_hz_s / bend;
  const double spread = std::sqrt(-d);
  if (!(ratio_s > 0.0) || spread * ratio_s >= 1.0) {
    return kNever_s;
  }
  return spread > 0.0 ? std::atanh(spread * ratio_s) / spread : ratio_s;
}

}  // namespace

GridState later(const grid::SfrModel& model, const GridState& state, double duration_s) {
  const double final_hz = -model.gain_hz_per_mw() * state.power_mw;
  const double distance_hz = state.deviation_hz - final_hz;
  const double omega_n_squared = model.omega_n() * model.omega_n();
  const double sigma = model.sigma_per_s();
  const grid::Modes mode = model.modes(duration_s);
  GridState result = state;
  result.deviation_hz =
      final_hz + distance_hz * (mode.c + sigma * mode.s) + state.slope_hz_s * mode.s;
  result.slope_hz_s =
      state.slope_hz_s * (mode.c - sigma * mode.s) - omega_n_squared * distance_hz * mode.s;
  // The integral of the differential equation.
  result.cycles +=
      final_hz * duration_s - (result.slope_hz_s - state.slope_hz_s +
                               2.0 * sigma * (result.deviation_hz - state.deviation_hz)) /
                                  omega_n_squared;
  return result;
}

GridState with_power(const grid::SfrModel& model, const GridState& state, double power_mw) {
  GridState result = state;
  result.slope_hz_s -=
      model.gain_hz_per_mw() * model.initial_slope_per_s() * (power_mw - state.power_mw);
  result.power_mw = power_mw;
  return result;
}

double lowest_deviation_hz(const grid::SfrModel& model, const GridState& state) {
  const double final_hz = -model.gain_hz_per_mw() * state.power_mw;
  double lowest_hz = std::min(state.deviation_hz, final_hz);
  const double first_s = stationary_s(model, state.deviation_hz - final_hz, state.slope_hz_s);
  if (first_s < kNever_s) {
    lowest_hz = std::min(lowest_hz, later(model, state, first_s).deviation_hz);
    // Underdamped, every half period has one; only the first two can be the lowest.
    if (model.discriminant_per_s2() > 0.0) {
      const double second_s = first_s + kPi / std::sqrt(model.discriminant_per_s2());
      lowest_hz = std::min(lowest_hz, later(model, state, second_s).deviation_hz);
    }
  }
  return lowest_hz;
}

void GridResponse::change(double at_s, double power_mw) {
  const bool in_order = changes_.empty() || at_s >= changes_.back().at_s;
  if (!std::isfinite(at_s) || !std::isfinite(power_mw) || !in_order) {
    throw std::invalid_argument(
        fmt::format("a change of {} MW at {} s; both must be finite, and changes in the order of "
                    "time",
                    power_mw, at_s));
  }
  const GridState before = at(at_s);
  const GridState after = with_power(model_, before, before.power_mw + power_mw);
  if (!changes_.empty() && changes_.back().at_s == at_s) {
    changes_.back().state = after;
  } else {
    changes_.push_back({at_s, after});
  }
}

GridState GridResponse::at(double t_s) const {
  const auto next =
      std::upper_bound(changes_.begin(), changes_.end(), t_s,
                       [](double t, const Change& change) { return t < change.at_s; });
  if (next == changes_.begin()) {
    return {};
  }
  const Change& last = *(next - 1);
  return later(model_, last.state, t_s - last.at_s);
}

std::vector<double> GridResponse::changes_s(double from_s, double end_s) const {
  std::vector<double> result;
  auto change = std::lower_bound(changes_.begin(), changes_.end(), from_s,
                                 [](const Change& each, double t_s) { return each.at_s < t_s; });
  for (; change != changes_.end() && change->at_s < end_s; ++change) {
    result.push_back(change->at_s);
  }
  return result;
}

}  // namespace gsbench::fleet
