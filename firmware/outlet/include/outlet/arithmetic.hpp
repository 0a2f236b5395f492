// Elementary functions as polynomials. The C library's results differ between machines in the last
// bit. An outlet, its emulation and the bench must agree in every bit. The templates have no
// branches, so `Real` may be a vector of floats (one trajectory per lane). Each lane then has the
// same result as a single float.
#pragma once

#include <cstdint>

namespace gs::outlet {

constexpr float kPi = 3.14159265358979f;
constexpr float kNotANumber = __builtin_nanf("");
constexpr float kTwoPi = 6.28318530717959f;

// Square root, correctly rounded by IEEE 754 on every target (VSQRT, SQRTSS).
inline float root(float x) {
  return __builtin_sqrtf(x);
}

// a if the condition is true, else b.
inline float select(bool condition, float a, float b) {
  return condition ? a : b;
}

template <class Real>
Real minimum(Real a, Real b) {
  return select(b < a, b, a);
}

template <class Real>
Real maximum(Real a, Real b) {
  return select(a < b, b, a);
}

// x within [low, high]; a NaN becomes `low`.
template <class Real>
Real bounded(Real x, Real low, Real high) {
  return minimum(select(x > low, x, low), high);
}

// sin(x) for |x| <= π: folded to |x| <= π/2, Taylor series, error below 2e-7.
template <class Real>
Real sine(Real x) {
  const Real folded = select(x > 0.5f * kPi, kPi - x, select(x < -0.5f * kPi, -kPi - x, x));
  const Real z = folded * folded;
  Real sum = Real{} - 2.5052108e-8f;
  sum = sum * z + 2.7557319e-6f;
  sum = sum * z - 1.9841270e-4f;
  sum = sum * z + 8.3333333e-3f;
  sum = sum * z - 1.6666667e-1f;
  return folded + folded * z * sum;
}

// cos(x) for |x| <= π.
template <class Real>
Real cosine(Real x) {
  return sine(0.5f * kPi - select(x < 0.0f, -x, x));
}

// e^x for −24 <= x <= 0, as (e^(x/16))^16. Absolute error below 1e-6. Relative error below 2e-6 for
// x >= −6, then growing to 4 % at x = −24, where e^x is 4e-11.
template <class Real>
Real exponential(Real x) {
  const Real y = x * 0.0625f;
  Real sum = Real{} + 1.9841270e-4f;
  sum = sum * y + 1.3888889e-3f;
  sum = sum * y + 8.3333333e-3f;
  sum = sum * y + 4.1666667e-2f;
  sum = sum * y + 1.6666667e-1f;
  sum = sum * y + 0.5f;
  sum = sum * y + 1.0f;
  sum = sum * y + 1.0f;
  sum = sum * sum;
  sum = sum * sum;
  sum = sum * sum;
  return sum * sum;
}

// Natural logarithm of a positive normal number. Error below 2e-5.
inline float logarithm(float x) {
  std::uint32_t bits = 0;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const auto exponent = static_cast<std::int32_t>(bits >> 23) - 127;
  const std::uint32_t mantissa_bits = (bits & 0x007FFFFFu) | 0x3F800000u;
  float mantissa = 0.0f;  // 1 … 2
  __builtin_memcpy(&mantissa, &mantissa_bits, sizeof mantissa);
  const float t = (mantissa - 1.0f) / (mantissa + 1.0f);
  const float z = t * t;
  const float half = t * (1.0f + z * (0.33333333f + z * (0.2f + z * 0.14285714f)));
  return 0.69314718f * static_cast<float>(exponent) + 2.0f * half;
}

// Angle of the point (x, y), from −π to π; 0 for (0, 0). The order of the arguments is that of
// atan2. Error below 5e-7 rad.
inline float angle_of(float y, float x) {
  const float ax = x < 0.0f ? -x : x;
  const float ay = y < 0.0f ? -y : y;
  const float larger = ax > ay ? ax : ay;
  const float smaller = ax > ay ? ay : ax;
  if (!(larger > 0.0f)) {
    return 0.0f;
  }
  const float q = smaller / larger;
  const float z = q * q;
  // Abramowitz & Stegun 4.4.49.
  float sum = 0.0028662257f;
  sum = sum * z - 0.0161657367f;
  sum = sum * z + 0.0429096138f;
  sum = sum * z - 0.0752896400f;
  sum = sum * z + 0.1065626393f;
  sum = sum * z - 0.1420889944f;
  sum = sum * z + 0.1999355085f;
  sum = sum * z - 0.3333314528f;
  float angle = q + q * z * sum;
  angle = ax > ay ? angle : 0.5f * kPi - angle;
  angle = x < 0.0f ? kPi - angle : angle;
  return y < 0.0f ? -angle : angle;
}

// The whole number nearest to x, for |x| < 2³¹.
inline float nearest_whole(float x) {
  return static_cast<float>(static_cast<std::int32_t>(x + (x < 0.0f ? -0.5f : 0.5f)));
}

// x wrapped into [−π, π], for |x| up to a few hundred turns.
inline float wrapped(float x) {
  return x - nearest_whole(x * (1.0f / kTwoPi)) * kTwoPi;
}

}  // namespace gs::outlet
