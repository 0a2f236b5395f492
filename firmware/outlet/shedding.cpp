#include <outlet/shedding.hpp>

namespace gs::outlet {

Shedding shedding(const GridStep& step, const GridState& state, float limit_hz) {
  const float loss_mw = maximum(state.loss_mw, 0.0f);
  // The model is linear. The predicted deviation is that of the state without lost power, plus the
  // lost power times that of 1 MW.
  GridState unloaded = {state.deviation_hz, state.unloaded_rocof_hz_s, 0.0f};
  GridState of_1_mw = {0.0f, 0.0f, 1.0f};
  Shedding result = {state.deviation_hz, 0.0f};
  float best_hz = state.deviation_hz;
  for (int i = 0; i < kLookAheadSteps; ++i) {
    unloaded = advanced(step, unloaded);
    of_1_mw = advanced(step, of_1_mw);
    best_hz = minimum(best_hz, unloaded.deviation_hz);
    result.nadir_hz =
        minimum(result.nadir_hz, unloaded.deviation_hz + state.loss_mw * of_1_mw.deviation_hz);
  }
  const float goal_hz = minimum(limit_hz, best_hz - kOutOfReach_hz);
  if (!(result.nadir_hz < goal_hz)) {
    return result;
  }
  unloaded = {state.deviation_hz, state.unloaded_rocof_hz_s, 0.0f};
  of_1_mw = {0.0f, 0.0f, 1.0f};
  for (int i = 0; i < kLookAheadSteps; ++i) {
    unloaded = advanced(step, unloaded);
    of_1_mw = advanced(step, of_1_mw);
    const float lowest_hz = unloaded.deviation_hz + loss_mw * of_1_mw.deviation_hz;
    result.required_mw = maximum(result.required_mw, (goal_hz - lowest_hz) / -of_1_mw.deviation_hz);
  }
  result.required_mw = minimum(result.required_mw, loss_mw);
  return result;
}

}  // namespace gs::outlet
