// Eq. (17) by itself, for the check of a grid and for the settings alike.
#pragma once

#include <grid/grid.hpp>

namespace gsbench::grid {

// f^B of `power_mw` of load behind `less_important_mw` that is shed before it. The paper's sum runs
// over i, its own index; what is meant is j = 1 … i−1, the blocks already off.
inline double block_switch_off_hz(const Grid& grid, double less_important_mw, double power_mw) {
  return grid.threshold_hz -
         power_mw / (grid.damping_pu * (grid.load_mw - less_important_mw)) * grid.nominal_hz;
}

}  // namespace gsbench::grid
