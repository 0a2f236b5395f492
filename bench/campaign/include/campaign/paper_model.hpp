// A model for the firmware's EKF: the frequency after a loss, computed from the paper's five
// parameters, eqs. (20) and (24)–(27). The paper adds independent errors to these five parameters.
// The four parameters of an outlet cannot represent such errors.
#pragma once

#include <outlet/response.hpp>

namespace gsbench::campaign {

template <class Parameter>
struct PaperModel {
  Parameter gain_hz_per_mw{};  // −G_1, in Hz per MW
  Parameter alpha{};           // G_2/G_1 at τ = 0
  Parameter sigma_per_s{};     // ζ·ω_n
  Parameter omega_r{};         // rad/s
  Parameter phi{};             // rad
};

// Frequency response to a unit loss at time τ. Precondition: |ω_r·τ + φ| <= π.
template <class Parameter, class Real>
gs::outlet::UnitResponse<Real> unit_response(const PaperModel<Parameter>& m, Real tau_s) {
  using gs::outlet::exponential;
  const Real decay = exponential(tau_s * -m.sigma_per_s) * m.alpha;
  const Real angle = tau_s * m.omega_r + m.phi;
  const Real sine = gs::outlet::sine(angle);
  const Real cosine = gs::outlet::cosine(angle);
  return {1.0f + decay * sine, decay * (cosine * m.omega_r - sine * m.sigma_per_s)};
}

}  // namespace gsbench::campaign
