#include <outlet/grid_model.hpp>

namespace gs::outlet {
namespace {

// The series is accurate up to kLongestSeries_s. A longer step is halved until it is shorter, and
// its matrix is then squared as often.
constexpr int kSeriesTerms = 16;
constexpr float kLongestSeries_s = 0.1f;

GridStep product(const GridStep& second, const GridStep& first) {
  GridStep both;
  for (int row = 0; row < kGridVariables; ++row) {
    for (int column = 0; column < kGridVariables; ++column) {
      for (int k = 0; k < kGridVariables; ++k) {
        both.to[row][column] += second.to[row][k] * first.to[k][column];
      }
    }
  }
  return both;
}

}  // namespace

GridStep grid_step(const Response& r, float step_s) {
  const float omega_n2 = r.discriminant_per_s2 + r.sigma_per_s * r.sigma_per_s;
  int doublings = 0;
  while (step_s > kLongestSeries_s) {
    step_s *= 0.5f;
    ++doublings;
  }
  GridStep rates;  // derivatives of the state, per second
  auto& rate = rates.to;
  rate[kPhase][kDeviation] = 1.0f;
  rate[kDeviation][kUnloadedRocof] = 1.0f;
  rate[kDeviation][kLoss] = -r.gain_hz_per_mw * r.initial_slope_per_s;
  rate[kUnloadedRocof][kDeviation] = -omega_n2;
  rate[kUnloadedRocof][kUnloadedRocof] = -2.0f * r.sigma_per_s;
  rate[kUnloadedRocof][kLoss] =
      r.gain_hz_per_mw * (2.0f * r.sigma_per_s * r.initial_slope_per_s - omega_n2);

  // Matrix exponential by Horner's scheme: I + X·(I + X/2·(I + X/3·(…))), X = rate · step_s.
  GridStep step;
  for (int i = 0; i < kGridVariables; ++i) {
    step.to[i][i] = 1.0f;
  }
  for (int order = kSeriesTerms; order >= 1; --order) {
    const float part_s = step_s / static_cast<float>(order);
    step = product(rates, step);
    for (int row = 0; row < kGridVariables; ++row) {
      for (int column = 0; column < kGridVariables; ++column) {
        step.to[row][column] = (row == column ? 1.0f : 0.0f) + part_s * step.to[row][column];
      }
    }
  }
  for (; doublings > 0; --doublings) {
    step = product(step, step);
  }
  return step;
}

}  // namespace gs::outlet
