#include <outlet/grid_model.hpp>

namespace gs::outlet {
namespace {

constexpr int kSeriesTerms = 16;

}  // namespace

GridStep grid_step(const Response& r, float step_s) {
  const float omega_n2 = r.discriminant_per_s2 + r.sigma_per_s * r.sigma_per_s;
  float rate[kGridVariables][kGridVariables] = {};  // per second
  rate[kPhase][kDeviation] = 1.0f;
  rate[kDeviation][kUnloadedRocof] = 1.0f;
  rate[kDeviation][kLoss] = -r.gain_hz_per_mw * r.initial_slope_per_s;
  rate[kUnloadedRocof][kDeviation] = -omega_n2;
  rate[kUnloadedRocof][kUnloadedRocof] = -2.0f * r.sigma_per_s;
  rate[kUnloadedRocof][kLoss] =
      r.gain_hz_per_mw * (2.0f * r.sigma_per_s * r.initial_slope_per_s - omega_n2);

  // Matrix exponential by its series, from the inside: I + X·(I + X/2·(I + X/3·(…))), X = rate · step_s.
  GridStep step;
  for (int i = 0; i < kGridVariables; ++i) {
    step.to[i][i] = 1.0f;
  }
  for (int order = kSeriesTerms; order >= 1; --order) {
    const GridStep inner = step;
    for (int row = 0; row < kGridVariables; ++row) {
      for (int column = 0; column < kGridVariables; ++column) {
        float sum = 0.0f;
        for (int k = 0; k < kGridVariables; ++k) {
          sum += rate[row][k] * inner.to[k][column];
        }
        step.to[row][column] =
            (row == column ? 1.0f : 0.0f) + sum * (step_s / static_cast<float>(order));
      }
    }
  }
  return step;
}

GridState advanced(const GridStep& step, const GridState& s) {
  const auto row = [&](GridVariable of) {
    return step.to[of][kDeviation] * s.deviation_hz +
           step.to[of][kUnloadedRocof] * s.unloaded_rocof_hz_s + step.to[of][kLoss] * s.loss_mw;
  };
  return {row(kDeviation), row(kUnloadedRocof), s.loss_mw};
}

}  // namespace gs::outlet
