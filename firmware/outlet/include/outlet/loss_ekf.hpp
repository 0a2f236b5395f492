// Extended Kalman filter (EKF), eq. (22)–(28). It estimates X = (ΔP, t_x), the lost power and the
// instant of the loss, from successive measured frequencies. Both are constant.
//
// The innovation is f(k) − h(X) with the full model h. Eq. (28) as printed uses the linearised h.
// The state is bounded: ΔP to [0, largest], t_x to the half second before the event. The covariance
// cannot grow, and its diagonal has a floor that single precision can represent. Therefore no
// measurement, however wrong, makes the filter diverge.
#pragma once

#include <outlet/response.hpp>

namespace gs::outlet {

constexpr float kEarliestLoss_s = -0.5f;  // t_x relative to the event
constexpr float kLatestLoss_s = 0.0f;

template <class Real>
struct EkfState {
  Real loss_mw{};
  Real t_x_s{};  // relative to the event; τ = t − t_x
  // Covariance: loss·loss, loss·t_x, t_x·t_x.
  Real p_ll{};
  Real p_lt{};
  Real p_tt{};
  Real residual_squares{};  // Σ of squared innovations, Hz²
  int count = 0;
};

struct EkfSettings {
  float measurement_sigma_hz = 0.005f;
  float loss_sigma_mw = 80.0f;  // of the LSE that starts the EKF
  float t_x_sigma_s = 0.02f;
  float largest_loss_mw = 0.0f;
};

template <class Real>
void start(const EkfSettings& settings, EkfState<Real>& s, Real loss_mw, Real t_x_s) {
  s.loss_mw = bounded(loss_mw, Real{}, Real{} + settings.largest_loss_mw);
  s.t_x_s = bounded(t_x_s, Real{} + kEarliestLoss_s, Real{} + kLatestLoss_s);
  s.p_ll = Real{} + settings.loss_sigma_mw * settings.loss_sigma_mw;
  s.p_lt = Real{};
  s.p_tt = Real{} + settings.t_x_sigma_s * settings.t_x_sigma_s;
  s.residual_squares = Real{};
  s.count = 0;
}

// Takes one measurement: `deviation_hz` from the frequency before the event, `t_s` after the event.
// `Model`: an argument type of unit_response() that has gain_hz_per_mw.
template <class Model, class Real>
void update(const EkfSettings& settings, const Model& response, EkfState<Real>& s,
            Real deviation_hz, float t_s) {
  const Real tau = maximum(t_s - s.t_x_s, Real{});
  const UnitResponse<Real> u = unit_response(response, tau);
  // h = −K·ΔP·u(t − t_x), with its derivatives with respect to ΔP and t_x.
  const Real h_loss = u.value * -response.gain_hz_per_mw;
  const Real h_t_x = s.loss_mw * u.slope_per_s * response.gain_hz_per_mw;
  const Real innovation = deviation_hz - s.loss_mw * h_loss;

  const Real ph_loss = s.p_ll * h_loss + s.p_lt * h_t_x;
  const Real ph_t_x = s.p_lt * h_loss + s.p_tt * h_t_x;
  const float r = settings.measurement_sigma_hz * settings.measurement_sigma_hz;
  const Real inverse = 1.0f / (h_loss * ph_loss + h_t_x * ph_t_x + r);
  const Real gain_loss = ph_loss * inverse;
  const Real gain_t_x = ph_t_x * inverse;

  s.loss_mw =
      bounded(s.loss_mw + gain_loss * innovation, Real{}, Real{} + settings.largest_loss_mw);
  s.t_x_s =
      bounded(s.t_x_s + gain_t_x * innovation, Real{} + kEarliestLoss_s, Real{} + kLatestLoss_s);
  // Floor: a thousandth of the initial σ, far below the resolution of 16-bit voltage samples.
  const float floor_ll = 1.0e-6f * settings.loss_sigma_mw * settings.loss_sigma_mw;
  const float floor_tt = 1.0e-6f * settings.t_x_sigma_s * settings.t_x_sigma_s;
  s.p_ll = maximum(s.p_ll - gain_loss * ph_loss, Real{} + floor_ll);
  s.p_lt = s.p_lt - gain_loss * ph_t_x;
  s.p_tt = maximum(s.p_tt - gain_t_x * ph_t_x, Real{} + floor_tt);
  // |p_lt| <= √(p_ll·p_tt) keeps the matrix positive semidefinite despite rounding and floors.
  const Real limit = root(s.p_ll * s.p_tt);
  s.p_lt = bounded(s.p_lt, -limit, limit);
  s.residual_squares = s.residual_squares + innovation * innovation;
  ++s.count;
}

}  // namespace gs::outlet
