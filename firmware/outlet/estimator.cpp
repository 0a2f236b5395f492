#include <outlet/conditions.hpp>
#include <outlet/estimator.hpp>

namespace gs::outlet {
namespace {

EkfSettings ekf_settings(const Settings& settings) {
  EkfSettings ekf;
  ekf.measurement_sigma_hz = settings.measurement_sigma_hz;
  ekf.loss_sigma_mw = settings.loss_sigma_mw;
  ekf.t_x_sigma_s = settings.t_x_sigma_s;
  ekf.largest_loss_mw = settings.largest_loss_mw;
  return ekf;
}

void observe_valid(const Settings& settings, EstimatorState& state, float deviation_hz) {
  if (state.started) {
    update(ekf_settings(settings), settings.response, state.ekf, deviation_hz,
           kReportS * static_cast<float>(state.reports));
    return;
  }
  add(state.lse, deviation_hz);
  if (state.lse.count == settings.lse_samples) {
    state.lse_loss_mw = k_lse_mw_per_hz_s(settings.response) * slope_hz_s(state.lse);
    // The fall began where the drops began.
    const float t_x_s = -kReportS * static_cast<float>(settings.event_drops);
    start(ekf_settings(settings), state.ekf, state.lse_loss_mw, t_x_s);
    state.started = true;
  }
}

}  // namespace

const char* to_string(Trust trust) {
  switch (trust) {
    case Trust::kTrusted:
      return "trusted";
    case Trust::kNotYet:
      return "not yet estimated";
    case Trust::kUnsteadyStart:
      return "frequency not steady before the event";
    case Trust::kResidual:
      return "measurements do not follow the model";
    case Trust::kAtBound:
      return "at the bound of what is physical";
    case Trust::kUncertain:
      return "too uncertain";
  }
  return "unknown";
}

void begin(EstimatorState& state, const Baseline& baseline) {
  state = EstimatorState{};
  state.baseline = baseline;
}

void observe(const Settings& settings, float nominal_hz, EstimatorState& state, bool valid,
             float frequency_hz, const Line& line) {
  if (valid) {
    // Not during the LSE: the tracker is still catching up with the corner then, and its slope is
    // steeper than the grid's.
    if (state.started && condition_met(settings, nominal_hz, line)) {
      ++state.hits;
    }
    observe_valid(settings, state, frequency_hz - state.baseline.frequency_hz);
  } else if (!state.started) {
    // The slope needs measurements that follow one another.
    state.lse = LseState<float>{};
  }
  ++state.reports;
}

bool complete(const Settings& settings, const EstimatorState& state) {
  return state.reports >= settings.lse_samples + settings.ekf_samples;
}

Trust trust(const Settings& settings, const EstimatorState& state) {
  if (!state.started || 2 * state.ekf.count < settings.ekf_samples) {
    return Trust::kNotYet;
  }
  const float slope = state.baseline.rocof_hz_s;
  if (!(slope > -kSteadyHzS && slope < kSteadyHzS)) {
    return Trust::kUnsteadyStart;
  }
  const EkfState<float>& ekf = state.ekf;
  if (ekf.loss_mw <= 0.0f || ekf.loss_mw >= settings.largest_loss_mw ||
      ekf.t_x_s <= kEarliestLossS || ekf.t_x_s >= kLatestLossS) {
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
  return state.ekf.t_x_s - kFrontEndDelayS;
}

}  // namespace gs::outlet
