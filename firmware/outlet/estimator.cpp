#include <outlet/conditions.hpp>
#include <outlet/decision.hpp>
#include <outlet/estimator.hpp>
#include <outlet/name_table.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {
const char* to_string(Trust trust) {
  static constexpr const char* kNames[] = {
      "trusted",
      "not yet estimated",
      "frequency not steady before the event",
      "measurements do not follow the model",
      "estimate at a physical bound",
      "too uncertain",
  };
  return name_of<kLastTrust>(trust, kNames);
}

void begin(EstimatorState& state, const Baseline& baseline) {
  state = EstimatorState{};
  state.baseline = baseline;
}

void observe(const Settings& settings, float nominal_hz, EstimatorState& state, bool valid,
             float frequency_hz, const Line& line) {
  if (valid) {
    // Hits are not counted during the LSE: the tracker has not settled after the onset, and its
    // slope is steeper than the grid's.
    if (state.started && condition_met(settings, nominal_hz, line)) {
      ++state.hits;
    }
    take(settings, settings.response, state, frequency_hz - state.baseline.frequency_hz,
         state.reports);
  } else if (!state.started) {
    restart_lse(state);
  }
  ++state.reports;
}

bool complete(const Settings& settings, const EstimatorState& state) {
  return state.reports >= reports_to_decision(settings);
}

Trust trust(const Settings& settings, const EstimatorState& state) {
  if (!state.started || 2 * state.ekf.count < settings.ekf_samples) {
    return Trust::kNotYet;
  }
  const float slope = state.baseline.rocof_hz_s;
  if (!(slope > -kSteady_hz_s && slope < kSteady_hz_s)) {
    return Trust::kUnsteadyStart;
  }
  const EkfState<float>& ekf = state.ekf;
  if (ekf.loss_mw <= 0.0f || ekf.loss_mw >= settings.largest_loss_mw ||
      ekf.t_x_s <= kEarliestLoss_s || ekf.t_x_s >= kLatestLoss_s) {
    return Trust::kAtBound;
  }
  const float allowed = settings.trusted_residual_hz * settings.trusted_residual_hz;
  if (!(ekf.residual_squares <= allowed * static_cast<float>(ekf.count))) {
    return Trust::kResidual;
  }
  if (!(loss_sigma_mw(state) <= 0.1f * ekf.loss_mw)) {
    return Trust::kUncertain;
  }
  return Trust::kTrusted;
}

float loss_sigma_mw(const EstimatorState& state) {
  return root(state.ekf.p_ll);
}

float loss_instant_s(const EstimatorState& state) {
  return state.ekf.t_x_s - kFrontEndDelay_s;
}

}  // namespace gs::outlet
