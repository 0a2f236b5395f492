// The noise is normally distributed, white, and independent from stream to stream. Limits are five
// standard errors of each statistic unless stated otherwise: a correct generator exceeds them once
// in 1.7 million, and the seed is fixed.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <models/noise.hpp>

namespace gsbench::models {
namespace {

constexpr std::size_t kCount = 4'000'000;

std::vector<float> gaussians(std::uint32_t index) {
  std::vector<float> values(kCount, 0.0f);
  add_gaussian({2019, kTest, index}, 0, kCount, 1.0f, values.data());
  return values;
}

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

double mean_of_product(const std::vector<float>& a, const std::vector<float>& b, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = lag; i < a.size(); ++i) {
    sum += static_cast<double>(a[i]) * static_cast<double>(b[i - lag]);
  }
  return sum / static_cast<double>(a.size() - lag);
}

TEST(GaussianStatistics, HasTheFirstFourMomentsOfTheStandardNormalDistribution) {
  double sum[4] = {};
  for (const float value : gaussians(0)) {
    double power = 1.0;
    for (double& entry : sum) {
      entry += power *= static_cast<double>(value);
    }
  }
  const double n = kCount;
  EXPECT_NEAR(sum[0] / n, 0.0, 5 * std::sqrt(1 / n));
  EXPECT_NEAR(sum[1] / n, 1.0, 5 * std::sqrt(2 / n));   // var x² = 3 − 1
  EXPECT_NEAR(sum[2] / n, 0.0, 5 * std::sqrt(15 / n));  // var x³ = 15
  EXPECT_NEAR(sum[3] / n, 3.0, 5 * std::sqrt(96 / n));  // var x⁴ = 105 − 9
}

TEST(GaussianStatistics, FollowsTheNormalDistributionFunction) {
  std::vector<float> values = gaussians(1);
  std::sort(values.begin(), values.end());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double cdf = normal_cdf(static_cast<double>(values[i]));
    const double below = static_cast<double>(i) / kCount;
    distance = std::max({distance, cdf - below, below + 1.0 / kCount - cdf});
  }
  // Kolmogorov–Smirnov: P(√n·D > 2.5) = 2·e^(−2·2.5²) = 7·10⁻⁶. Below 0.2 the values would be too
  // regular.
  EXPECT_LT(distance * std::sqrt(static_cast<double>(kCount)), 2.5);
  EXPECT_GT(distance * std::sqrt(static_cast<double>(kCount)), 0.2);
}

// The tails determine the false events in a thousand hours. The counts beyond 3, 4 and 5 sigma in
// 64 million values are Poisson-distributed with the expectation of the normal distribution.
TEST(GaussianStatistics, HasTheTailsOfTheNormalDistribution) {
  constexpr std::size_t kBlock = 1 << 16;
  constexpr std::size_t kBlocks = 1000;
  std::size_t beyond[3] = {};
  double largest = 0.0;
  std::vector<float> values(kBlock);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    std::fill(values.begin(), values.end(), 0.0f);
    add_gaussian({2016, kTest, 0}, block * kBlock, kBlock, 1.0f, values.data());
    for (const float value : values) {
      const double magnitude = std::fabs(static_cast<double>(value));
      for (std::size_t i = 0; i < 3; ++i) {
        beyond[i] += magnitude > static_cast<double>(3 + i);
      }
      largest = std::max(largest, magnitude);
    }
  }
  const double n = static_cast<double>(kBlock) * kBlocks;
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = 2.0 * n * normal_cdf(-static_cast<double>(3 + i));
    EXPECT_NEAR(static_cast<double>(beyond[i]), expected, 5 * std::sqrt(expected)) << 3 + i << " σ";
  }
  // The largest of 6.5·10⁷: below 5.1 with probability e^(−22), above 6.7 with 1.4·10⁻³.
  EXPECT_GT(largest, 5.1);
  EXPECT_LT(largest, 6.7);
}

// The two values of a Box–Muller pair share a radius; their squares show a dependence that the
// values would not. Lags cover the batch of 64, its quarters and the 16 ms at 8 kHz.
TEST(GaussianStatistics, HasUncorrelatedValuesAndSquares) {
  const std::vector<float> values = gaussians(2);
  std::vector<float> squares(values.size());
  std::transform(values.begin(), values.end(), squares.begin(),
                 [](float value) { return value * value - 1.0f; });
  const double n = kCount;
  for (const std::size_t lag : {1, 2, 3, 4, 15, 16, 17, 31, 32, 33, 48, 63, 64, 65, 128, 256}) {
    EXPECT_NEAR(mean_of_product(values, values, lag), 0.0, 5 / std::sqrt(n)) << "lag " << lag;
    EXPECT_NEAR(mean_of_product(squares, squares, lag), 0.0, 5 * 2 / std::sqrt(n)) << "lag " << lag;
  }
}

TEST(GaussianStatistics, HasIndependentNeighbouringStreams) {
  const std::vector<float> one = gaussians(3);
  const std::vector<float> next = gaussians(4);
  for (const std::size_t lag : {0, 1, 4, 16, 64}) {
    EXPECT_NEAR(mean_of_product(one, next, lag), 0.0, 5 / std::sqrt(static_cast<double>(kCount)));
  }
}

}  // namespace
}  // namespace gsbench::models
