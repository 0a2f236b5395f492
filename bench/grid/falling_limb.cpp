#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>

namespace gsbench::grid {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double depth_at(const SfrModel& model, double t_s) {
  return -model.unit_deviation_hz(t_s) / model.gain_hz_per_mw();
}

// The zero of eq. (12): g0·C + (omega_n² − sigma·g0)·S = 0 and, with g0 = omega_n²·T_R,
// S/C = T_R/(sigma·T_R − 1). Underdamped, S/C is tan(√d·t)/√d, which gives eq. (13). At zeta = 1 it
// is t. Overdamped, it is tanh(√−d·t)/√−d, which stays below 1/√−d: there may be no zero.
double time_of_nadir_s(const SfrModel& model) {
  const double sigma = model.sigma_per_s();
  const double d = model.discriminant_per_s2();
  const double omega_n_squared = model.omega_n() * model.omega_n();
  const double reheat_s = model.initial_slope_per_s() / omega_n_squared;
  if (d > 0.0) {
    const double omega_r = std::sqrt(d);
    return std::atan2(reheat_s * omega_r, sigma * reheat_s - 1.0) / omega_r;
  }
  const double spread = std::sqrt(-d);
  const double slow = omega_n_squared / (sigma + spread);
  const double lead = slow * reheat_s - 1.0;  // > 0 if the zero at −1/T_R is slower than both poles
  if (lead <= 0.0) {
    return kNever;
  }
  if (spread == 0.0) {
    return reheat_s / lead;
  }
  return std::log1p(2.0 * spread * reheat_s / lead) / (2.0 * spread);
}

}  // namespace

UnitNadir unit_nadir(const SfrModel& model) {
  const double t_s = time_of_nadir_s(model);
  if (t_s == kNever) {
    return {kNever, 1.0};
  }
  const double depth = depth_at(model, t_s);
  // At F_H = 1 the zero cancels a pole, and only rounding decides whether there is a minimum.
  // An undershoot below the rounding error of the three terms of eq. (6) does not count as one.
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (depth < 1.0 + kRounding) {
    return {kNever, 1.0};
  }
  return {t_s, depth};
}

double time_at_depth_s(const SfrModel& model, const UnitNadir& lowest, double depth) {
  double before_s = 0.0;
  double after_s = lowest.t_s;
  if (after_s == kNever) {
    after_s = 1.0 / model.initial_slope_per_s();
    while (depth_at(model, after_s) < depth) {
      after_s *= 2.0;
    }
  }
  // Bisection down to neighbouring numbers. The deviation grows monotonically until the nadir;
  // methods that use the slope would fail near the nadir, where it is zero.
  for (;;) {
    const double middle_s = 0.5 * (before_s + after_s);
    if (middle_s <= before_s || middle_s >= after_s) {
      return middle_s;
    }
    (depth_at(model, middle_s) < depth ? before_s : after_s) = middle_s;
  }
}

Nadir nadir(const SfrModel& model, double loss_mw) {
  if (!(loss_mw >= 0.0)) {
    throw std::invalid_argument(fmt::format("loss_mw is {}; it must be at least 0", loss_mw));
  }
  const UnitNadir lowest = unit_nadir(model);
  return {lowest.t_s, model.nominal_hz() - loss_mw * model.gain_hz_per_mw() * lowest.depth};
}

}  // namespace gsbench::grid
