#include "claim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <oracle/power_system.hpp>

namespace gsbench::oracle {
namespace {

double loss_of_a_tenth_mw(const grid::Grid& grid) {
  return 0.1 * grid.load_mw;
}

// The largest difference of claimed and simulated values, relative to the largest simulated value.
class Largest {
 public:
  void add(double claimed, long double simulated) {
    difference_ = std::max(difference_, std::abs(claimed - simulated));
    size_ = std::max(size_, std::abs(simulated));
    finite_ = finite_ && std::isfinite(claimed);
  }
  double relative() const {
    return finite_ ? static_cast<double>(difference_ / size_)
                   : std::numeric_limits<double>::infinity();
  }

 private:
  long double difference_ = 0.0L;
  long double size_ = std::numeric_limits<long double>::min();
  bool finite_ = true;
};

double relative(double claimed, long double simulated) {
  Largest one;
  one.add(claimed, simulated);
  return one.relative();
}

double nadir_time_disagreement(const grid::Nadir& claimed, const Nadir& simulated) {
  if (!simulated.t_s) {
    return std::isinf(claimed.t_s) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  const long double undershoot = simulated.deviation_hz / simulated.end_deviation_hz - 1.0L;
  if (undershoot < 1e-6L) {
    return 0.0;
  }
  return relative(claimed.t_s, *simulated.t_s);
}

double conditions_disagreement(const grid::Grid& grid, const PowerSystem& system,
                               long double threshold_mw,
                               const std::vector<control_centre::Condition>& claimed) {
  std::vector<long double> deviations_hz;
  for (std::size_t i = 0; i + 1 < claimed.size(); ++i) {
    deviations_hz.push_back(static_cast<long double>(claimed[i].from_hz) - grid.nominal_hz);
  }
  const auto simulated = system.rocof_at_deviation(threshold_mw, deviations_hz);
  Largest largest;
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    largest.add(claimed[i].rocof_below_hz_s, simulated[i]);
  }
  largest.add(claimed.back().rocof_below_hz_s, 0.0L);
  return largest.relative();
}

}  // namespace

double Disagreement::worst() const {
  return std::max({deviation, rocof, phase, nadir, nadir_time, threshold, k_lse, conditions});
}

Claim claim_of(const Scenario& scenario) {
  const grid::Grid& grid = scenario.grid;
  const grid::SfrModel model(grid);
  const grid::FrequencyResponse response(model, scenario.changes);
  Claim claim;
  for (const double t_s : scenario.times_s) {
    claim.courses.push_back({response.frequency_hz(t_s) - grid.nominal_hz, response.rocof_hz_s(t_s),
                             response.excess_cycles(t_s)});
  }
  claim.nadir = grid::nadir(model, loss_of_a_tenth_mw(grid));
  claim.threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  claim.k_lse_mw_per_hz_s = control_centre::k_lse_mw_per_hz_s(model);
  claim.conditions = control_centre::conditions(model, grid.threshold_hz, grid.condition_row_hz);
  return claim;
}

Disagreement compare(const Scenario& scenario, const Claim& claim) {
  const grid::Grid& grid = scenario.grid;
  const PowerSystem system(grid);

  Largest deviation, rocof, phase;
  const std::vector<Sample> samples = system.simulate(scenario.changes, scenario.times_s);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    deviation.add(claim.courses[i].deviation_hz, samples[i].deviation_hz);
    rocof.add(claim.courses[i].rocof_hz_s, samples[i].rocof_hz_s);
    phase.add(claim.courses[i].excess_cycles, samples[i].phase_cycles);
  }

  const double loss_mw = loss_of_a_tenth_mw(grid);
  const Nadir nadir = system.nadir(loss_mw);
  const long double threshold_mw = loss_mw *
                                   (static_cast<long double>(grid.threshold_hz) - grid.nominal_hz) /
                                   nadir.deviation_hz;
  const long double k_lse = loss_mw / system.simulate({{0.0, loss_mw}}, {0.0}).front().rocof_hz_s;
  return {deviation.relative(),
          rocof.relative(),
          phase.relative(),
          relative(claim.nadir.frequency_hz - grid.nominal_hz, nadir.deviation_hz),
          nadir_time_disagreement(claim.nadir, nadir),
          relative(claim.threshold_mw, threshold_mw),
          relative(claim.k_lse_mw_per_hz_s, k_lse),
          conditions_disagreement(grid, system, threshold_mw, claim.conditions)};
}

}  // namespace gsbench::oracle
