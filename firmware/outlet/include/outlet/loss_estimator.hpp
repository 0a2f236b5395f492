// Estimate of the lost power from the frequencies measured after an event (§5.3, §5.4). The LSE
// takes the first measurements. The EKF takes the last kSharedSamples of these and all later ones.
// The outlet (Real = float) and campaigns (Real = a vector with one trajectory per lane) share
// this code.
#pragma once

#include <outlet/loss_ekf.hpp>
#include <outlet/loss_lse.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

// Number of the LSE's last measurements that the EKF also takes. The older ones were measured
// before the tracker had settled after the onset. If the EKF took all ten, its estimate of 500 MW
// would be 1.6 % too high. If it took only one, the estimate's standard deviation would be 0.52 %
// instead of 0.37 %.
constexpr int kSharedSamples = 4;

template <class Real>
struct LossEstimator {
  LseState<Real> lse;
  EkfState<Real> ekf;
  Real lse_loss_mw{};
  Real newest_hz[kSharedSamples] = {};  // deviations taken by the LSE, the newest first
  bool started = false;                 // the LSE is done, the EKF runs
};

inline EkfSettings ekf_settings(const Settings& settings) {
  EkfSettings ekf;
  ekf.measurement_sigma_hz = settings.measurement_sigma_hz;
  ekf.loss_sigma_mw = settings.loss_sigma_mw;
  ekf.t_x_sigma_s = settings.t_x_sigma_s;
  ekf.largest_loss_mw = settings.largest_loss_mw;
  return ekf;
}

// Discards the LSE's measurements so far. To be called after a gap: the LSE needs successive ones.
template <class Real>
void restart_lse(LossEstimator<Real>& s) {
  s.lse = LseState<Real>{};
}

// Takes one measurement. `deviation_hz`: its deviation from the frequency before the event.
// `report`: its index; the measurement that completed the event has index 0. An outlet passes
// settings.response as `response`.
template <class Model, class Real>
void take(const Settings& settings, const Model& response, LossEstimator<Real>& s,
          Real deviation_hz, int report) {
  const EkfSettings ekf = ekf_settings(settings);
  if (s.started) {
    update(ekf, response, s.ekf, deviation_hz, kReport_s * static_cast<float>(report));
    return;
  }
  add(s.lse, deviation_hz);
  for (int age = kSharedSamples - 1; age > 0; --age) {
    s.newest_hz[age] = s.newest_hz[age - 1];
  }
  s.newest_hz[0] = deviation_hz;
  if (s.lse.count < settings.lse_samples) {
    return;
  }
  s.lse_loss_mw = slope_hz_s(s.lse) * k_lse_mw_per_hz_s(response);
  const Real t_x_s =
      Real{} - (kReport_s * static_cast<float>(settings.event_drops) + settings.event_lag_s);
  start(ekf, s.ekf, s.lse_loss_mw, t_x_s);
  s.started = true;
  const int shared = s.lse.count < kSharedSamples ? s.lse.count : kSharedSamples;
  for (int age = shared - 1; age >= 0; --age) {
    update(ekf, response, s.ekf, s.newest_hz[age], kReport_s * static_cast<float>(report - age));
  }
  s.ekf.count = 0;  // counts only later measurements; residual_squares includes the shared ones
}

}  // namespace gs::outlet
