// Results of the closed forms in bench/grid, compared with the simulated power system.
#pragma once

#include <control_centre/threshold.hpp>

#include <vector>

#include <grid/falling_limb.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::oracle {

struct Course {
  double deviation_hz;
  double rocof_hz_s;
  double excess_cycles;
};

struct Claim {
  std::vector<Course> courses;  // at Scenario::times_s
  grid::Nadir nadir;            // after a loss of a tenth of the load
  double threshold_mw;
  double k_lse_mw_per_hz_s;
  std::vector<control_centre::Condition> conditions;
};

struct Scenario {
  grid::Grid grid;
  std::vector<grid::PowerChange> changes;
  std::vector<double> times_s;
};

// Largest differences, relative to the largest simulated value; infinite if a claim is not finite
// although it should be.
struct Disagreement {
  double deviation;
  double rocof;
  double phase;
  double nadir;
  double nadir_time;  // 0 if the undershoot is below 1e-6 of the end value: too flat to time
  double threshold;
  double k_lse;
  double conditions;

  double worst() const;
};

Claim claim_of(const Scenario& scenario);
Disagreement compare(const Scenario& scenario, const Claim& claim);

}  // namespace gsbench::oracle
