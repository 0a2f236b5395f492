// The fall of the frequency after a loss, up to its turn, per unit of the deviation in the end.
#pragma once

#include <grid/sfr_model.hpp>

namespace gsbench::grid {

struct TurningPoint {
  double t_s;    // +infinity where the frequency falls to its end value without a turn
  double depth;  // lowest deviation over that in the end, >= 1
};

TurningPoint turning_point(const SfrModel& model);

// When the falling limb passes `depth`, 0 < depth < turn.depth.
double time_at_depth_s(const SfrModel& model, const TurningPoint& turn, double depth);

}  // namespace gsbench::grid
