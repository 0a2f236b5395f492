// The grid's frequency response (response.hpp) in state-space form, for any course of the lost
// power p(t). Its step response is u(τ):
//   dφ/dt  = Δf
//   dΔf/dt = q − K·g0·p
//   dq/dt  = −ω_n²·Δf − 2σ·q + K·(2σ·g0 − ω_n²)·p
// φ: phase relative to nominal, cycles. Δf: deviation from nominal, Hz. p: lost power, MW; negative
// if power is in excess. q: the ROCOF if all lost power returned now, Hz/s. A step of p changes the
// ROCOF at once, but neither q nor Δf.
#pragma once

#include <outlet/response.hpp>

namespace gs::outlet {

// Indices of φ, Δf, q and p.
enum GridVariable : std::uint8_t { kPhase, kDeviation, kUnloadedRocof, kLoss, kGridVariables };

// Transition matrix of a time step with constant p: state after = to · state before, in the order
// and units of GridVariable.
struct GridStep {
  float to[kGridVariables][kGridVariables] = {};
};

// The transition matrix over step_s, 0 < step_s <= 10, of a stable response. Relative error below
// 1e-5.
GridStep grid_step(const Response& response, float step_s);

// The state without the phase.
struct GridState {
  float deviation_hz = 0.0f;         // Δf
  float unloaded_rocof_hz_s = 0.0f;  // q
  float loss_mw = 0.0f;              // p
};

// The state one step later, with constant p.
inline GridState advanced(const GridStep& step, const GridState& s) {
  const auto row = [&](GridVariable of) {
    return step.to[of][kDeviation] * s.deviation_hz +
           step.to[of][kUnloadedRocof] * s.unloaded_rocof_hz_s + step.to[of][kLoss] * s.loss_mw;
  };
  return {row(kDeviation), row(kUnloadedRocof), s.loss_mw};
}

}  // namespace gs::outlet
