// The fall of the frequency after a loss, up to its turning point, per unit of the final deviation.
#pragma once

#include <grid/sfr_model.hpp>

namespace gsbench::grid {

struct TurningPoint {
  double t_s;    // +infinity if the frequency falls to its final value without a turning point
  double depth;  // largest deviation per final deviation, >= 1
};

TurningPoint turning_point(const SfrModel& model);

// Time at which the falling limb passes `depth`, 0 < depth < turn.depth.
double time_at_depth_s(const SfrModel& model, const TurningPoint& turn, double depth);

struct Nadir {
  double t_s;  // +infinity if the frequency falls to its final value without a turning point
  double frequency_hz;
};

// Lowest frequency after one loss at t = 0, eq. (13), (14). Throws std::invalid_argument if loss_mw
// is negative or NaN.
Nadir nadir(const SfrModel& model, double loss_mw);

}  // namespace gsbench::grid
