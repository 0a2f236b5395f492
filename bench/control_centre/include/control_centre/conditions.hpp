// The load-shedding conditions, Table 1 of the paper.
#pragma once

#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::control_centre {

// One row: for from_hz <= f < to_hz the condition is met while ROCOF is below the limit.
struct Condition {
  double from_hz;
  double to_hz;
  double rocof_below_hz_s;  // the threshold loss's ROCOF where it passes from_hz, <= 0
};

// For rows of any height, from f_n down to f_s; the last row may be lower than the others. Throws
// std::invalid_argument as threshold_mw does, or where row_hz < grid::kLowestConditionRowHz.
std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz);

}  // namespace gsbench::control_centre
