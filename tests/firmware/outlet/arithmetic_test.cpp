// The firmware's functions compared with the C library's in double precision.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <outlet/arithmetic.hpp>

namespace gs::outlet {
namespace {

constexpr double kPiExactly = 3.14159265358979323846;
constexpr int kPoints = 200'000;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

float point(int i, float low, float high) {
  return low + (high - low) * (static_cast<float>(i) / static_cast<float>(kPoints));
}

// Largest error over [low, high]. It must be below the declared bound, but not by a factor of ten.
template <class Error>
double largest_error(float low, float high, Error error) {
  double largest = 0.0;
  for (int i = 0; i <= kPoints; ++i) {
    largest = std::max(largest, error(point(i, low, high)));
  }
  return largest;
}

void expect_tight(double largest, double declared) {
  EXPECT_LT(largest, declared);
  EXPECT_GT(largest, 0.1 * declared);
}

double error_of(float ours, double exact) {
  return std::abs(static_cast<double>(ours) - exact);
}

TEST(Arithmetic, SineAndCosineAreWithinTheirDeclaredErrorOverAWholeTurn) {
  const auto of_sine = [](float x) { return error_of(sine(x), std::sin(static_cast<double>(x))); };
  const auto of_cosine = [](float x) {
    return error_of(cosine(x), std::cos(static_cast<double>(x)));
  };
  expect_tight(largest_error(-kPi, kPi, of_sine), 2e-7);
  expect_tight(largest_error(-kPi, kPi, of_cosine), 2e-7);
}

TEST(Arithmetic, ExponentialIsWithinItsDeclaredErrors) {
  const auto absolute = [](float x) {
    return error_of(exponential(x), std::exp(static_cast<double>(x)));
  };
  const auto relative = [&](float x) { return absolute(x) / std::exp(static_cast<double>(x)); };
  expect_tight(largest_error(-24.0F, 0.0F, absolute), 1e-6);
  expect_tight(largest_error(-6.0F, 0.0F, relative), 2e-6);
}

TEST(Arithmetic, AngleOfAVectorIsWithinItsDeclaredErrorInEveryDirection) {
  for (const float length : {1e-6F, 1.0F, 1e6F}) {
    const auto error = [length](float x) {
      const auto angle = static_cast<double>(x);
      const auto across = length * static_cast<float>(std::sin(angle));
      const auto along = length * static_cast<float>(std::cos(angle));
      return error_of(angle_of(across, along),
                      std::atan2(static_cast<double>(across), static_cast<double>(along)));
    };
    expect_tight(largest_error(-kPi, kPi, error), 5e-7);
  }
}

TEST(Arithmetic, AngleIsExactOnTheAxesAndZeroAtTheOrigin) {
  EXPECT_EQ(angle_of(0.0F, 1.0F), 0.0F);
  EXPECT_EQ(angle_of(1.0F, 0.0F), 0.5F * kPi);
  EXPECT_EQ(angle_of(-1.0F, 0.0F), -0.5F * kPi);
  EXPECT_EQ(angle_of(0.0F, -1.0F), kPi);
  EXPECT_EQ(angle_of(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(angle_of(kNaN, kNaN), 0.0F);
}

// At 300 turns, 1885 rad, a float's resolution is 1.2e-4 rad. The nearest float to 2π has an error
// of 1.7e-7.
TEST(Arithmetic, WrappingSubtractsWholeTurnsOnly) {
  constexpr double kAllowed = 1.2e-4 + 300 * 1.8e-7;
  for (int i = 0; i <= kPoints; ++i) {
    const float x = point(i, -300.0F * kTwoPi, 300.0F * kTwoPi);
    const auto y = static_cast<double>(wrapped(x));
    ASSERT_LE(std::abs(y), kPiExactly + kAllowed) << x;
    ASSERT_LE(std::abs(std::remainder(static_cast<double>(x) - y, 2.0 * kPiExactly)), kAllowed)
        << x;
  }
}

TEST(Arithmetic, WrappingDoesNotChangeAnglesWithinHalfATurn) {
  for (const float x : {-3.14F, -1.0F, 0.0F, 1e-20F, 2.5F, 3.14F}) {
    EXPECT_EQ(wrapped(x), x);
  }
}

TEST(Arithmetic, BoundedClampsToTheNearerBound) {
  EXPECT_EQ(bounded(0.5F, 0.0F, 1.0F), 0.5F);
  EXPECT_EQ(bounded(-0.5F, 0.0F, 1.0F), 0.0F);
  EXPECT_EQ(bounded(1.5F, 0.0F, 1.0F), 1.0F);
  EXPECT_EQ(bounded(std::numeric_limits<float>::infinity(), 0.0F, 1.0F), 1.0F);
  EXPECT_EQ(bounded(-std::numeric_limits<float>::infinity(), 0.0F, 1.0F), 0.0F);
}

TEST(Arithmetic, BoundedMapsNaNToTheLowerBound) {
  EXPECT_EQ(bounded(kNaN, -2.0F, 1.0F), -2.0F);
}

}  // namespace
}  // namespace gs::outlet
