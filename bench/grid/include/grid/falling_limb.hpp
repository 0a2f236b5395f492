// The fall of the frequency after a loss, down to the nadir. `depth` is the deviation divided by
// the final steady-state deviation; it does not depend on the loss.
#pragma once

#include <grid/sfr_model.hpp>

namespace gsbench::grid {

struct UnitNadir {
  double t_s;    // +infinity if the frequency falls to its final value without a minimum before
  double depth;  // at the nadir, >= 1; 1 without a minimum
};

UnitNadir unit_nadir(const SfrModel& model);

// Time from the loss until the falling frequency first reaches `depth`, which is before the nadir.
// Requires 0 < depth < lowest.depth.
double time_at_depth_s(const SfrModel& model, const UnitNadir& lowest, double depth);

struct Nadir {
  double t_s;  // +infinity if the frequency falls to its final value without a minimum before
  double frequency_hz;
};

// Lowest frequency after one loss at t = 0, eq. (13), (14). Throws std::invalid_argument if loss_mw
// is negative or NaN.
Nadir nadir(const SfrModel& model, double loss_mw);

}  // namespace gsbench::grid
