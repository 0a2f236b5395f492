#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

// Integrals of the two modes from 0 to t_s. With A' = −sigma·A − d·B and B' = A − sigma·B they are
// (1 − A − sigma·B)/omega_n² of B, and B + sigma·∫B of A.
struct Areas {
  double c;
  double s;
};

Areas areas_until(const SfrModel& model, double t_s) {
  const Modes mode = model.modes(t_s);
  const double sigma = model.sigma_per_s();
  const double s = (1.0 - mode.c - sigma * mode.s) / (model.omega_n() * model.omega_n());
  return {mode.s + sigma * s, s};
}

double inertia_of_all_s(const Grid& grid) {  // eq. (2)
  double stored_mws = 0.0;
  for (const Plant& plant : grid.plants) {
    stored_mws += plant.inertia_s * plant.rating_mw;
  }
  return stored_mws / grid.base_mw;
}

double droop_of_all_pu(const Grid& grid) {
  double regulation_mw = 0.0;  // of all governors together, per unit of frequency
  for (const Plant& plant : grid.plants) {
    regulation_mw += plant.rating_mw / plant.droop_pu;
  }
  return grid.base_mw / regulation_mw;
}

const Grid& checked(const Grid& grid) {
  check(grid);
  return grid;
}

}  // namespace

SfrModel::SfrModel(const Grid& grid)
    : inertia_s_(inertia_of_all_s(checked(grid))),
      droop_pu_(droop_of_all_pu(grid)),
      nominal_hz_(grid.nominal_hz),
      base_mw_(grid.base_mw) {
  const double stiffness_pu = grid.damping_pu + grid.gain_km / droop_pu_;  // (D·R + K_m)/R
  const double prompt_pu = grid.damping_pu + grid.gain_km * grid.reheat_fraction / droop_pu_;
  const double omega_n_squared = stiffness_pu / (2.0 * inertia_s_ * grid.reheat_s);
  omega_n_ = std::sqrt(omega_n_squared);                                  // eq. (4)
  sigma_ = 0.5 * (1.0 / grid.reheat_s + prompt_pu / (2.0 * inertia_s_));  // eq. (5) times omega_n
  zeta_ = sigma_ / omega_n_;
  d_ = omega_n_squared - sigma_ * sigma_;
  g0_ = stiffness_pu / (2.0 * inertia_s_);
  gain_ = nominal_hz_ / (base_mw_ * stiffness_pu);
}

Modes SfrModel::modes(double t_s) const {
  if (d_ > 0.0) {
    const double omega_r = std::sqrt(d_);
    const double decay = std::exp(-sigma_ * t_s);
    return {decay * std::cos(omega_r * t_s), decay * std::sin(omega_r * t_s) / omega_r};
  }
  // cosh and sinh could overflow although their product with the decay is small, so the slow pole
  // is factored out. It is computed as a quotient, because sigma − spread loses digits far from
  // critical damping.
  const double spread = std::sqrt(-d_);
  const double slow = omega_n_ * omega_n_ / (sigma_ + spread);
  const double decay = std::exp(-slow * t_s);
  const double lost = -std::expm1(-2.0 * spread * t_s);  // 1 − e^(−2·spread·t)
  return {decay * (1.0 - 0.5 * lost), decay * (spread > 0.0 ? lost / (2.0 * spread) : t_s)};
}

double SfrModel::unit_deviation_hz(double t_s, double ramp_s) const {
  if (ramp_s > 0.0) {
    return (unit_phase_cycles(t_s) - unit_phase_cycles(t_s - ramp_s)) / ramp_s;
  }
  if (t_s < 0.0) {
    return 0.0;
  }
  const Modes mode = modes(t_s);
  return -gain_ * (1.0 - mode.c + (g0_ - sigma_) * mode.s);
}

double SfrModel::unit_rocof_hz_s(double t_s, double ramp_s) const {
  if (ramp_s > 0.0) {
    return (unit_deviation_hz(t_s) - unit_deviation_hz(t_s - ramp_s)) / ramp_s;
  }
  if (t_s < 0.0) {
    return 0.0;
  }
  const Modes mode = modes(t_s);
  return -gain_ * (g0_ * mode.c + (omega_n_ * omega_n_ - sigma_ * g0_) * mode.s);
}

// With A = e^(−sigma·t)·C and B = e^(−sigma·t)·S: A' = −sigma·A − d·B and B' = A − sigma·B. Solved
// for A and B, these give the integrals of A and B, and so the integral of the deviation.
double SfrModel::unit_phase_cycles(double t_s, double ramp_s) const {
  if (t_s < 0.0) {
    return 0.0;
  }
  const double omega_n_squared = omega_n_ * omega_n_;
  if (ramp_s > 0.0) {
    // Neither the squares of the times nor the times are subtracted: the result would lose digits
    // late in a long run.
    const double moved_s = std::fmin(t_s, ramp_s);
    const Areas from = areas_until(*this, t_s - moved_s);
    const Areas to = areas_until(*this, t_s);
    const double transient = (2.0 * sigma_ - g0_) * (moved_s - (to.c - from.c)) +
                             (omega_n_squared - sigma_ * (2.0 * sigma_ - g0_)) * (to.s - from.s);
    return -gain_ * (moved_s * (t_s - 0.5 * moved_s) - transient / omega_n_squared) / ramp_s;
  }
  const Modes mode = modes(t_s);
  const double transient = (2.0 * sigma_ - g0_) * (1.0 - mode.c) +
                           (omega_n_squared - sigma_ * (2.0 * sigma_ - g0_)) * mode.s;
  return -gain_ * (t_s - transient / omega_n_squared);
}

std::optional<UnderdampedParameters> underdamped_parameters(const SfrModel& model,
                                                            double reheat_s) {
  if (model.discriminant_per_s2() <= 0.0) {
    return std::nullopt;
  }
  const double omega_r = std::sqrt(model.discriminant_per_s2());  // eq. (8)
  const double cosine = 1.0 - model.sigma_per_s() * reheat_s;
  const double sine = omega_r * reheat_s;
  // Eq. (7): its radicand is (1 − T_R·sigma)² + (T_R·omega_r)² over 1 − zeta².
  const double alpha = std::hypot(cosine, sine) * model.omega_n() / omega_r;
  // Eq. (9): both angles are in (0, π). The paper's tan⁻¹ does not determine the quadrant.
  const double phi1 = std::atan2(sine, cosine);
  const double phi2 = std::atan2(omega_r, -model.sigma_per_s());
  return UnderdampedParameters{alpha, omega_r, phi1 - phi2, phi1};
}

FrequencyResponse::FrequencyResponse(SfrModel model, std::vector<PowerChange> changes,
                                     double initial_deviation_hz)
    : model_(std::move(model)),
      changes_(std::move(changes)),
      initial_deviation_hz_(initial_deviation_hz) {
  if (!std::isfinite(initial_deviation_hz)) {
    throw std::invalid_argument(
        fmt::format("the initial deviation is {} Hz; it must be finite", initial_deviation_hz));
  }
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const PowerChange& change = changes_[i];
    if (!std::isfinite(change.at_s) || !std::isfinite(change.power_mw)) {
      throw std::invalid_argument(
          fmt::format("power change {} is {} MW at {} s; both must be finite", i + 1,
                      change.power_mw, change.at_s));
    }
    if (!std::isfinite(change.ramp_s) || change.ramp_s < 0.0) {
      throw std::invalid_argument(
          fmt::format("power change {} has a ramp of {} s; it must be finite and at least 0", i + 1,
                      change.ramp_s));
    }
  }
}

double FrequencyResponse::sum(double (SfrModel::*of_one_mw)(double t_s, double ramp_s) const,
                              double t_s) const {
  double sum = 0.0;
  for (const PowerChange& change : changes_) {
    sum += change.power_mw * (model_.*of_one_mw)(t_s - change.at_s, change.ramp_s);
  }
  return sum;
}

}  // namespace gsbench::grid
