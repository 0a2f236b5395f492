// The firmware's series for the frequency response compared with the closed form in double
// precision: the C library's functions, and a separate formula for each damping.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <outlet/response.hpp>

namespace gs::outlet {
namespace {

struct Exact {
  double value;
  double slope;
};

// 1 − e^(−σt)·[C − (g0 − σ)·S] with trigonometric, limiting (d = 0) or hyperbolic C and S.
Exact exact_response(const Response& r, double t) {
  const auto sigma = static_cast<double>(r.sigma_per_s);
  const auto d = static_cast<double>(r.discriminant_per_s2);
  const auto g0 = static_cast<double>(r.initial_slope_per_s);
  const double root = std::sqrt(std::abs(d));
  double c = 1.0;
  double s = t;
  if (d > 0.0) {
    c = std::cos(root * t);
    s = std::sin(root * t) / root;
  } else if (d < 0.0) {
    c = std::cosh(root * t);
    s = std::sinh(root * t) / root;
  }
  const double decay = std::exp(-sigma * t);
  // Differentiated by the product rule: C' = −d·S, S' = C.
  const double inner = c - (g0 - sigma) * s;
  const double inner_slope = -d * s - (g0 - sigma) * c;
  return {1.0 - decay * inner, decay * (sigma * inner - inner_slope)};
}

Response response(float sigma_per_s, float discriminant_per_s2, float initial_slope_per_s) {
  Response r;
  r.gain_hz_per_mw = 1e-3F;
  r.sigma_per_s = sigma_per_s;
  r.discriminant_per_s2 = discriminant_per_s2;
  r.initial_slope_per_s = initial_slope_per_s;
  return r;
}

// Up to the limits of validation: |d|·τ² = 16 or σ·τ = 24 at τ = 1.5 s.
std::vector<Response> responses() {
  std::vector<Response> all;
  const float edge = kLargestSeriesArgument / (1.5F * 1.5F);
  for (const float d : {edge, 0.5F * edge, 0.068F, 1e-6F, 0.0F, -1e-6F, -0.5F, -edge}) {
    const float least_sigma = d < 0.0F ? std::sqrt(-d) : 0.0F;
    for (const float sigma : {0.05F, 0.3F, 2.0F, kLargestDecay / 1.5F}) {
      for (const float g0 : {0.1F, 1.26F, 10.0F}) {
        if (sigma > least_sigma) {
          all.push_back(response(sigma, d, g0));
        }
      }
    }
  }
  return all;
}

// Tolerance relative to the largest term of the sum: float rounding, the declared 1e-6 of the
// series and the decay's 3e-6.
constexpr double kAllowed = 5e-6;

TEST(Response, AgreesWithTheClosedFormForEveryDamping) {
  int compared = 0;
  for (const Response& r : responses()) {
    const double scale = 1.0 + static_cast<double>(r.initial_slope_per_s);
    for (int i = 0; i <= 300; ++i) {
      const float tau = 1.5F * static_cast<float>(i) / 300.0F;
      const UnitResponse<float> u = unit_response(r, tau);
      const Exact exact = exact_response(r, static_cast<double>(tau));
      const double rate = std::sqrt(std::abs(static_cast<double>(r.discriminant_per_s2))) +
                          static_cast<double>(r.sigma_per_s);
      ASSERT_NEAR(static_cast<double>(u.value), exact.value, kAllowed * scale)
          << "tau " << tau << " sigma " << r.sigma_per_s << " d " << r.discriminant_per_s2;
      ASSERT_NEAR(static_cast<double>(u.slope_per_s), exact.slope,
                  kAllowed * scale * std::max(1.0, rate))
          << "tau " << tau << " sigma " << r.sigma_per_s << " d " << r.discriminant_per_s2;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20'000);
}

TEST(Response, StartsAtZeroWithTheInitialSlope) {
  for (const Response& r : responses()) {
    const UnitResponse<float> u = unit_response(r, 0.0F);
    EXPECT_EQ(u.value, 0.0F);
    EXPECT_EQ(u.slope_per_s, r.initial_slope_per_s);
  }
}

// Central differences of the value, in float. Their errors are rounding, 2⁻²⁴ of a value up to 10
// divided by 2·h, and h² times the third derivative.
TEST(Response, ItsSlopeIsTheDerivativeOfItsValue) {
  const Response r = response(0.3F, 0.0682F, 1.262F);
  constexpr float kHalfStep = 0.02F;
  for (float tau = 0.1F; tau < 1.4F; tau += 0.05F) {
    const float difference =
        unit_response(r, tau + kHalfStep).value - unit_response(r, tau - kHalfStep).value;
    EXPECT_NEAR(unit_response(r, tau).slope_per_s, difference / (2.0F * kHalfStep), 5e-5F) << tau;
  }
}

TEST(Response, TheInitialSlopeGivesTheLoss) {
  const Response r = response(0.3F, 0.0682F, 1.262F);
  const float slope_hz_s = -500.0F * r.gain_hz_per_mw * unit_response(r, 0.0F).slope_per_s;
  EXPECT_NEAR(k_lse_mw_per_hz_s(r) * slope_hz_s, 500.0F, 1e-4F);
}

}  // namespace
}  // namespace gs::outlet
