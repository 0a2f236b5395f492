#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <oracle/power_system.hpp>

namespace gsbench::oracle {
namespace {

enum Row : Eigen::Index { kDeviation, kPhase, kLoss, kFirstReheater };

// Power of all rotors at a ROCOF of 1 Hz/s: the sum of 2·H·S/f_n.
long double inertia_mw_per_hz_s(const grid::Grid& grid) {
  long double sum = 0.0L;
  for (const grid::Plant& plant : grid.plants) {
    sum += 2.0L * plant.inertia_s * plant.rating_mw / grid.nominal_hz;
  }
  return sum;
}

}  // namespace

PowerSystem::PowerSystem(const grid::Grid& grid) {
  const auto plants = static_cast<Eigen::Index>(grid.plants.size());
  const Eigen::Index size = kFirstReheater + plants;
  dynamics_ = Matrix::Zero(size, size);
  const long double inertia = inertia_mw_per_hz_s(grid);
  const long double reheat_s = grid.reheat_s;
  const long double prompt = grid.reheat_fraction;

  // Eq. (1): additional generation minus lost power minus load damping.
  dynamics_(kDeviation, kDeviation) =
      -static_cast<long double>(grid.damping_pu) * grid.base_mw / grid.nominal_hz / inertia;
  dynamics_(kDeviation, kLoss) = -1.0L / inertia;
  dynamics_(kPhase, kDeviation) = 1.0L;
  for (Eigen::Index i = 0; i < plants; ++i) {
    const grid::Plant& plant = grid.plants[static_cast<std::size_t>(i)];
    // Fig. 1: the governor opens the valve by 1/R of the deviation, of which K_m becomes power:
    // F_H of it at once, the rest through the reheater, a lag of T_R.
    const long double power_mw_per_hz = -static_cast<long double>(grid.gain_km) * plant.rating_mw /
                                        plant.droop_pu / grid.nominal_hz;
    const Eigen::Index reheater = kFirstReheater + i;
    dynamics_(kDeviation, kDeviation) += prompt * power_mw_per_hz / inertia;
    dynamics_(kDeviation, reheater) = 1.0L / inertia;
    dynamics_(reheater, kDeviation) = (1.0L - prompt) * power_mw_per_hz / reheat_s;
    dynamics_(reheater, reheater) = -1.0L / reheat_s;
  }

  // The autonomous part: the loss is an input and the phase an output.
  Matrix moving(plants + 1, plants + 1);
  moving(0, 0) = dynamics_(kDeviation, kDeviation);
  moving.row(0).tail(plants) = dynamics_.row(kDeviation).tail(plants);
  moving.col(0).tail(plants) = dynamics_.col(kDeviation).tail(plants);
  moving.bottomRightCorner(plants, plants) = dynamics_.bottomRightCorner(plants, plants);
  const auto rates = Eigen::EigenSolver<Matrix>(moving, false).eigenvalues().eval();
  horizon_s_ = 45.0L / (-rates.real()).minCoeff();
  const State push = dynamics_(kDeviation, kLoss) * State::Unit(plants + 1, 0);
  end_deviation_hz_per_mw_ = -moving.fullPivLu().solve(push)(0);

  // A quarter of the fastest time constant: no cancellation in the Taylor series of e^(A·t), and
  // the first omitted term is 0.25^20/20! = 4e-31.
  step_s_ = 0.25L / rates.cwiseAbs().maxCoeff();
  step_ = Matrix::Identity(size, size);
  Matrix term = step_;
  for (int k = 1; k < kTerms; ++k) {
    term = (dynamics_ * term * (step_s_ / static_cast<long double>(k))).eval();
    step_ += term;
  }
}

PowerSystem::State PowerSystem::after_loss(long double loss_mw) const {
  State state = State::Zero(dynamics_.rows());
  state(kLoss) = loss_mw;
  return state;
}

void PowerSystem::advance(State& state, long double duration_s) const {
  State next(state.size());
  const long double steps = std::floor(duration_s / step_s_);
  for (long double done = 0.0L; done < steps; done += 1.0L) {
    next.noalias() = step_ * state;
    state.swap(next);
  }
  const long double rest_s = duration_s - steps * step_s_;
  State term = state;
  for (int k = 1; k < kTerms; ++k) {
    next.noalias() = dynamics_ * term;
    term = next * (rest_s / static_cast<long double>(k));
    state += term;
  }
}

Sample PowerSystem::sample(const State& state) const {
  return {state(kDeviation), dynamics_.row(kDeviation).dot(state), state(kPhase)};
}

std::vector<Sample> PowerSystem::simulate(const std::vector<grid::PowerChange>& changes,
                                          const std::vector<double>& times_s) const {
  std::vector<Sample> samples;
  State state = after_loss(0.0L);
  long double now_s = 0.0L;
  const auto advance_to = [&](long double t_s) {
    advance(state, t_s - now_s);
    now_s = t_s;
  };
  auto next = changes.begin();
  for (const double t_s : times_s) {
    for (; next != changes.end() && next->at_s <= t_s; ++next) {
      advance_to(next->at_s);
      state(kLoss) += next->power_mw;
    }
    advance_to(t_s);
    samples.push_back(sample(state));
  }
  return samples;
}

// The deviation within one step: a Taylor polynomial of the time since the start of the step.
class PowerSystem::Step {
 public:
  Step(const PowerSystem& system, const State& from) : length_s_(system.step_s_) {
    State derivative = from;
    long double factorial = 1.0L;
    for (int k = 0; k < kTerms; ++k) {
      if (k > 0) {
        derivative = (system.dynamics_ * derivative).eval();
        factorial *= static_cast<long double>(k);
      }
      coefficients_[static_cast<std::size_t>(k)] = derivative(kDeviation) / factorial;
    }
  }

  long double deviation_hz(long double s) const {
    long double sum = 0.0L;
    for (auto k = coefficients_.size(); k-- > 0;) {
      sum = sum * s + coefficients_[k];
    }
    return sum;
  }
  long double rocof_hz_s(long double s) const {
    long double sum = 0.0L;
    for (auto k = coefficients_.size(); k-- > 1;) {
      sum = sum * s + static_cast<long double>(k) * coefficients_[k];
    }
    return sum;
  }

  // The time at which `passed(time)` becomes true, by bisection.
  template <typename Passed>
  long double when(Passed passed) const {
    long double from_s = 0.0L;
    long double to_s = length_s_;
    for (int i = 0; i < std::numeric_limits<long double>::digits; ++i) {
      const long double middle_s = 0.5L * (from_s + to_s);
      (passed(middle_s) ? to_s : from_s) = middle_s;
    }
    return to_s;
  }

 private:
  std::array<long double, kTerms> coefficients_;
  long double length_s_;
};

Nadir PowerSystem::nadir(long double loss_mw) const {
  const long double end_hz = end_deviation_hz_per_mw_ * loss_mw;
  State state = after_loss(loss_mw);
  State next(state.size());
  for (long double t_s = 0.0L; t_s < horizon_s_; t_s += step_s_) {
    next.noalias() = step_ * state;
    if (sample(next).rocof_hz_s >= 0.0L) {
      const Step step(*this, state);
      const long double rest_s =
          step.when([&step](long double s) { return step.rocof_hz_s(s) >= 0.0L; });
      return {t_s + rest_s, step.deviation_hz(rest_s), end_hz};
    }
    state.swap(next);
  }
  return {std::nullopt, end_hz, end_hz};
}

std::vector<long double> PowerSystem::rocof_at_deviation(
    long double loss_mw, const std::vector<long double>& deviations_hz) const {
  std::vector<long double> rocofs_hz_s;
  State state = after_loss(loss_mw);
  State next = step_ * state;
  for (const long double deviation_hz : deviations_hz) {
    // The step with the nadir may start and end above a deviation that it passes in between.
    while (next(kDeviation) > deviation_hz && sample(next).rocof_hz_s < 0.0L) {
      state.swap(next);
      next.noalias() = step_ * state;
    }
    const Step step(*this, state);
    rocofs_hz_s.push_back(step.rocof_hz_s(step.when([&step, deviation_hz](long double s) {
      return step.deviation_hz(s) <= deviation_hz || step.rocof_hz_s(s) >= 0.0L;
    })));
  }
  return rocofs_hz_s;
}

}  // namespace gsbench::oracle
