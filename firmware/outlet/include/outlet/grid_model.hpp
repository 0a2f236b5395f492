// The grid's frequency response (response.hpp) in state-space form, for any course of the lost
// power: the step response u(τ) is that of
//   dφ/dt  = Δf
//   dΔf/dt = q − K·g0·p
//   dq/dt  = −ω_n²·Δf − 2σ·q + K·(2σ·g0 − ω_n²)·p
// with the phase φ relative to nominal (cycles), the deviation Δf from nominal (Hz), and the lost
// power p (MW). q is the ROCOF that the grid would have if the lost power returned now (Hz/s): it
// is continuous when p changes, the ROCOF is not.
#pragma once

#include <outlet/response.hpp>

namespace gs::outlet {

enum GridVariable : std::uint8_t { kPhase, kDeviation, kUnloadedRocof, kLoss, kGridVariables };

// State after a time step = to · state before it, while p is constant.
struct GridStep {
  float to[kGridVariables][kGridVariables] = {};
};

// Requires 0 < step_s <= 10 and a stable response. Relative error below 1e-5.
GridStep grid_step(const Response& response, float step_s);

// Deviation and q, with p constant. For the phase see GridStep.
struct GridState {
  float deviation_hz = 0.0f;
  float unloaded_rocof_hz_s = 0.0f;
  float loss_mw = 0.0f;
};

GridState advanced(const GridStep& step, const GridState& state);

}  // namespace gs::outlet
