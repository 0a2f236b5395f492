// System frequency response of a grid to power changes: eq. (1)–(10) in closed form, for any
// damping (under-, critically and overdamped).
//
// With sigma = zeta·omega_n and d = omega_n² − sigma² the response to a unit step of lost power is
//   deviation(t) = −K·[1 − e^(−sigma·t)·C(t) + (g0 − sigma)·e^(−sigma·t)·S(t)]
// where C = cos(√d·t), S = sin(√d·t)/√d for d > 0, their limits for d = 0, cosh and sinh for d < 0,
// K = R/(D·R + K_m) and g0 = omega_n²·T_R. For zeta < 1 this is eq. (6), because α·sin(φ) = −1.
// The response to power lost linearly over a time T is the mean of the response to a step over the
// last T, also in closed form, because C and S can be integrated any number of times.
// The denominator of eq. (3) is misprinted in the paper: it is s² + 2·zeta·omega_n·s + omega_n².
#pragma once

#include <optional>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::grid {

// The two modes of the response with their decay: c = e^(−sigma·t)·C(t), s = e^(−sigma·t)·S(t).
struct Modes {
  double c;
  double s;
};

class SfrModel {
 public:
  // Throws GridError if the grid is invalid.
  explicit SfrModel(const Grid& grid);

  double inertia_s() const { return inertia_s_; }     // H, eq. (2), on base_mw
  double droop_pu() const { return droop_pu_; }       // R, on base_mw: 1/R = Σ S_i/(R_i·S_B)
  double omega_n() const { return omega_n_; }         // eq. (4), rad/s
  double zeta() const { return zeta_; }               // eq. (5)
  double sigma_per_s() const { return sigma_; }       // zeta·omega_n, 1/s
  double discriminant_per_s2() const { return d_; }   // omega_n² − sigma²; < 0 when overdamped
  double initial_slope_per_s() const { return g0_; }  // g0 above, 1/s
  double gain_hz_per_mw() const { return gain_; }  // K: steady-state deviation, Hz per MW lost, > 0
  double nominal_hz() const { return nominal_hz_; }
  double base_mw() const { return base_mw_; }

  // Response to one MW lost at t = 0, or linearly from t = 0 to ramp_s; all zero for t < 0. Exact.
  // ramp_s: 0, or so long that t_s/ramp_s stays below 10⁹, beyond which digits are lost.
  double unit_deviation_hz(double t_s, double ramp_s = 0.0) const;  // eq. (6), negative
  double unit_rocof_hz_s(double t_s, double ramp_s = 0.0) const;  // eq. (12); right-hand limit at 0
  double unit_phase_cycles(double t_s, double ramp_s = 0.0) const;  // ∫ unit_deviation_hz dt

  Modes modes(double t_s) const;  // t_s >= 0

 private:
  double inertia_s_, droop_pu_, omega_n_, zeta_, sigma_, d_, g0_, gain_, nominal_hz_, base_mw_;
};

// The paper's closed-form parameters of eq. (7)–(9), (12).
struct UnderdampedParameters {
  double alpha;
  double omega_r;  // rad/s
  double phi;      // rad
  double phi1;     // rad, in (0, π)
};

// nullopt for zeta >= 1, where they do not exist. reheat_s: T_R of the model's grid.
std::optional<UnderdampedParameters> underdamped_parameters(const SfrModel& model, double reheat_s);

// Several power changes superposed, eq. (10).
class FrequencyResponse {
 public:
  // The grid is in equilibrium before the first change, initial_deviation_hz away from nominal: as
  // if the power with this final deviation had been lost long before. The model is linear, so the
  // deviation stays and adds to the response. Throws std::invalid_argument if a value is not
  // finite, or a ramp negative.
  FrequencyResponse(SfrModel model, std::vector<PowerChange> changes,
                    double initial_deviation_hz = 0.0);

  double frequency_hz(double t_s) const {
    return model_.nominal_hz() + initial_deviation_hz_ + sum(&SfrModel::unit_deviation_hz, t_s);
  }
  // At the start or end of a change, the right-hand limit.
  double rocof_hz_s(double t_s) const { return sum(&SfrModel::unit_rocof_hz_s, t_s); }
  // Phase advance relative to nominal, in cycles: ∫ (f − f_n) dt, exact. Before the first change,
  // 0 at t = 0.
  double excess_cycles(double t_s) const {
    return initial_deviation_hz_ * t_s + sum(&SfrModel::unit_phase_cycles, t_s);
  }

  const SfrModel& model() const { return model_; }
  const std::vector<PowerChange>& changes() const { return changes_; }

 private:
  double sum(double (SfrModel::*of_one_mw)(double t_s, double ramp_s) const, double t_s) const;

  SfrModel model_;
  std::vector<PowerChange> changes_;
  double initial_deviation_hz_;
};

}  // namespace gsbench::grid
