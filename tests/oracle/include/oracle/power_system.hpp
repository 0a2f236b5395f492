// A power system simulated, not solved: eq. (1) and the block diagram of Fig. 1, plant by plant, in
// Hz and MW, integrated in long double. Nothing here comes from the closed forms that it is to
// judge: no eq. (2)–(18), no aggregate H and R, no per-unit base, no damping ratio.
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

struct Turn {
  std::optional<long double> t_s;  // nothing where the frequency falls to its end without a turn
  long double deviation_hz;        // the lowest, or that in the end
  long double end_deviation_hz;
};

class PowerSystem {
 public:
  explicit PowerSystem(const grid::Grid& grid);

  // At each of the ascending times, after the changes in ascending order; all at 0 s or later.
  std::vector<Sample> simulate(const std::vector<grid::PowerChange>& changes,
                               const std::vector<double>& times_s) const;

  // After a loss at t = 0, by watching the ROCOF.
  Turn turn(long double loss_mw) const;

  // ROCOF at which the frequency, falling after the loss at t = 0, first passes each of the
  // descending deviations. All must lie above the turn's.
  std::vector<long double> rocof_at_deviation(long double loss_mw,
                                              const std::vector<long double>& deviations_hz) const;

 private:
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  // Deviation in Hz, its integral in cycles, power lost in MW, then for each plant the power in MW
  // that its reheater passes on.
  using State = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  static constexpr int kTerms = 20;  // of each Taylor series
  class Step;

  State after_loss(long double loss_mw) const;
  void advance(State& state, long double duration_s) const;
  Sample sample(const State& state) const;

  Matrix dynamics_;  // d(state)/dt = dynamics·state
  Matrix step_;      // state one step_s_ later
  long double step_s_;
  long double horizon_s_;                // until a transient is below the rounding of long double
  long double end_deviation_hz_per_mw_;  // where nothing moves any more
};

}  // namespace gsbench::oracle
