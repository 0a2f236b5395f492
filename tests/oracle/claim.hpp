// What bench/grid claims of a grid, and how far the simulated power system disagrees.
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

// Each as the largest difference over the largest size of what is compared; infinite where a claim
// is not finite and should be.
struct Disagreement {
  double deviation;
  double rocof;
  double phase;
  double nadir;
  double nadir_time;  // 0 where the undershoot is too slight to time, below 1e-6 of the end value
  double threshold;
  double k_lse;
  double conditions;

  double worst() const;
};

Claim claim_of(const Scenario& scenario);
Disagreement compare(const Scenario& scenario, const Claim& claim);

}  // namespace gsbench::oracle
