// What must be shed, from the state of the grid: the least power that keeps the predicted nadir at
// the threshold frequency f_s, whatever happened before.
#pragma once

#include <outlet/grid_model.hpp>

namespace gs::outlet {

constexpr float kLookAhead_s = 0.1f;  // step of the prediction
constexpr int kLookAheadSteps = 80;   // the nadir comes within 8 s

// All deviations are from the nominal frequency.
struct Shedding {
  float nadir_hz = 0.0f;     // predicted if nothing is shed
  float required_mw = 0.0f;  // 0 … the lost power
};

// `step`: over kLookAhead_s. `limit_hz` < 0: f_s minus nominal. Where shedding all of the lost
// power cannot keep f_s any more, the limit is kOutOfReach_hz below the best that can be reached:
// otherwise all would be shed for the last millihertz.
constexpr float kOutOfReach_hz = 0.010f;
Shedding shedding(const GridStep& step, const GridState& state, float limit_hz);

}  // namespace gs::outlet
