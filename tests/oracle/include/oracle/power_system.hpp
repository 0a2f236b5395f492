// Numerical simulation of a power system as a reference for the closed forms: eq. (1) and the block
// diagram of Fig. 1, plant by plant, in Hz and MW, integrated in long double. It is independent of
// the closed forms: no eq. (2)–(18), no aggregate H and R, no per-unit base, no damping ratio.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include <grid/grid.hpp>

namespace gsbench::oracle {

struct Sample {
  long double deviation_hz;
  long double rocof_hz_s;
  long double phase_cycles;  // ∫ deviation from t = 0
};

struct Nadir {
  std::optional<long double> t_s;  // none: the frequency falls to its final value without a nadir
  long double deviation_hz;        // at the nadir, or the final value
  long double end_deviation_hz;
};

class PowerSystem {
 public:
  explicit PowerSystem(const grid::Grid& grid);

  // Samples at `times_s`. `changes` and `times_s` are ascending and not negative.
  std::vector<Sample> simulate(const std::vector<grid::PowerChange>& changes,
                               const std::vector<double>& times_s) const;

  // The nadir after a loss at t = 0: the first zero of the ROCOF.
  Nadir nadir(long double loss_mw) const;

  // ROCOF at the instants when the falling frequency first passes each of the descending
  // deviations, after a loss at t = 0. All deviations must lie above the nadir.
  std::vector<long double> rocof_at_deviation(long double loss_mw,
                                              const std::vector<long double>& deviations_hz) const;

 private:
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  // Deviation in Hz, its integral in cycles, lost power in MW, then the reheater power of each
  // plant in MW.
  using State = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  static constexpr int kTerms = 20;  // of each Taylor series
  class Step;

  State after_loss(long double loss_mw) const;
  void advance(State& state, long double duration_s) const;
  Sample sample(const State& state) const;

  Matrix dynamics_;  // d(state)/dt = dynamics·state
  Matrix step_;      // state one step_s_ later
  long double step_s_;
  long double horizon_s_;  // transients have decayed below the rounding of long double
  long double end_deviation_hz_per_mw_;  // steady state
};

}  // namespace gsbench::oracle
