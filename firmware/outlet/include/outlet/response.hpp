// Frequency response to a lost power: eq. (6) for any damping, from four parameters that the
// control centre sends. With d = omega_n² − sigma² and z = d·τ²
//   u(τ)  = 1 − e^(−sigma·τ)·[C − (g0 − sigma)·S],  C = cos √z, S = τ·sin √z / √z
//   u'(τ) = e^(−sigma·τ)·[g0·C + (omega_n² − sigma·g0)·S]
// and f(τ) = f_0 − K·ΔP·u(τ). For d < 0, cos and sin become cosh and sinh, but the power series of
// C and S in z stay the same. Therefore one branch-free form covers every damping.
#pragma once

#include <outlet/arithmetic.hpp>

namespace gs::outlet {

// `Parameter`: float, or a vector of floats if each lane of a campaign has its own parameters.
template <class Parameter>
struct ResponseOf {
  Parameter gain_hz_per_mw{};       // K, final deviation per MW
  Parameter sigma_per_s{};          // zeta·omega_n
  Parameter discriminant_per_s2{};  // d
  Parameter initial_slope_per_s{};  // g0 = omega_n²·T_R
};
using Response = ResponseOf<float>;

// The model is valid up to these limits. The first bounds |d|·τ²: up to it, the series have a
// relative error of 1e-6. The second bounds sigma·τ, for e^(−sigma·τ).
constexpr float kLargestSeriesArgument = 16.0f;
constexpr float kLargestDecay = 24.0f;

template <class Real>
struct UnitResponse {
  Real value;        // u(τ)
  Real slope_per_s;  // u'(τ)
};

// Requires τ >= 0, within the limits above.
template <class Parameter, class Real>
UnitResponse<Real> unit_response(const ResponseOf<Parameter>& r, Real tau_s) {
  const Real z = tau_s * tau_s * r.discriminant_per_s2;
  // Horner's scheme. Ratio of successive terms: −z/((2k)(2k−1)) in C, −z/((2k)(2k+1)) in S.
  Real c = Real{} + 1.0f;
  Real s = Real{} + 1.0f;
  for (int k = 11; k >= 1; --k) {
    const float even = 1.0f / static_cast<float>(2 * k * (2 * k - 1));
    const float odd = 1.0f / static_cast<float>(2 * k * (2 * k + 1));
    c = 1.0f - z * even * c;
    s = 1.0f - z * odd * s;
  }
  s = s * tau_s;
  const Real decay = exponential(tau_s * -r.sigma_per_s);
  const Parameter omega_n2 = r.discriminant_per_s2 + r.sigma_per_s * r.sigma_per_s;
  UnitResponse<Real> u;
  u.value = 1.0f - decay * (c - (r.initial_slope_per_s - r.sigma_per_s) * s);
  u.slope_per_s =
      decay * (r.initial_slope_per_s * c + (omega_n2 - r.sigma_per_s * r.initial_slope_per_s) * s);
  return u;
}

// K^LSE of eq. (18), MW per Hz/s: negative.
template <class Parameter>
Parameter k_lse_mw_per_hz_s(const ResponseOf<Parameter>& r) {
  return -1.0f / (r.gain_hz_per_mw * r.initial_slope_per_s);
}

}  // namespace gs::outlet
