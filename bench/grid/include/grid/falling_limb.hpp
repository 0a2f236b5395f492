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

struct Nadir {
  double t_s;  // +infinity where the frequency falls to its end value without a turn
  double frequency_hz;
};

// Lowest frequency after one loss at t = 0, eq. (13), (14). Throws std::invalid_argument for a
// negative loss, which has a highest frequency instead.
Nadir nadir(const SfrModel& model, double loss_mw);

}  // namespace gsbench::grid
