// The least power that must be shed now to keep the predicted nadir at a limit. It follows from the
// state of the grid alone, whatever happened before.
#pragma once

#include <outlet/grid_model.hpp>

namespace gs::outlet {

constexpr float kLookAhead_s = 0.1f;  // step of the prediction
constexpr int kLookAheadSteps = 80;   // the prediction covers 8 s

struct Shedding {
  float nadir_hz = 0.0f;     // deviation from nominal, predicted if nothing is shed
  float required_mw = 0.0f;  // 0 … the lost power
};

// `step`: grid_step(response, kLookAhead_s). `state`: at the time at which the load goes off.
// `limit_hz`: deviation from nominal, < 0. It is lowered to kOutOfReach_hz below the nadir that
// remains when all of the lost power is shed, if it is above that. Otherwise all load would be shed
// for the last millihertz.
constexpr float kOutOfReach_hz = 0.010f;
Shedding shedding(const GridStep& step, const GridState& state, float limit_hz);

}  // namespace gs::outlet
