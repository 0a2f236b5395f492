// Table 2 with fewer trajectories: with the shipped settings each cell is at least as good as the
// paper's.
#include <test_support/ieee24.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <campaign/conditions.hpp>

namespace gsbench::campaign {
namespace {

using test::ieee24;

ConditionOptions cell(double loss_mw, double noise_hz, std::uint64_t trajectories = 20000) {
  ConditionOptions options;
  options.loss_mw = loss_mw;
  options.noise_hz = noise_hz;
  options.counting = shipped_counting(ieee24());
  options.trajectories = trajectories;
  return options;
}

ConditionResult compute(const ConditionOptions& options, std::size_t threads = 2) {
  Execution execution;
  execution.threads = threads;
  return count_conditions(ieee24(), options, execution);
}

TEST(ConditionCampaign, WithoutNoiseOnlyALossAboveTheThresholdNeedsShedding) {
  EXPECT_EQ(compute(cell(380.0, 0.0)).probability(), 1.0);
  EXPECT_EQ(compute(cell(320.0, 0.0)).probability(), 0.0);
}

TEST(ConditionCampaign, EveryCellOfTable2IsAtLeastAsGoodAsThePapers) {
  // The paper's probability allows eight wrong decisions in a million trajectories.
  const ConditionResult rarely_missed = compute(cell(380.0, 0.005, 1000000));
  EXPECT_GE(rarely_missed.probability(), 0.999992);
  EXPECT_NEAR(rarely_missed.hits.mean(), 36.85, 0.05);
  const ConditionResult noisy = compute(cell(380.0, 0.010));
  EXPECT_GE(noisy.probability(), 0.978264);
  EXPECT_NEAR(noisy.hits.mean(), 30.56, 0.15);
  EXPECT_LE(compute(cell(320.0, 0.005)).probability(), 0.001029);
  EXPECT_LE(compute(cell(320.0, 0.010)).probability(), 0.117682);
}

// Wrong settings, to show that the limits above are tight enough.
TEST(ConditionCampaign, AHigherOrLowerNumberOfHitsIsWorseThanThePapers) {
  ConditionOptions wrong = cell(380.0, 0.005);
  wrong.counting.more_than = 30;
  EXPECT_LT(compute(wrong).probability(), 0.999);
  wrong = cell(320.0, 0.010);
  wrong.counting.more_than = 15;
  EXPECT_GT(compute(wrong).probability(), 0.3);
  wrong.noise_hz = 0.005;
  EXPECT_GT(compute(wrong).probability(), 0.01);
}

TEST(ConditionCampaign, IsTheSameOnAnyNumberOfThreads) {
  const ConditionResult one = compute(cell(320.0, 0.01), 1);
  for (const std::size_t threads : {2U, 3U}) {
    const ConditionResult other = compute(cell(320.0, 0.01), threads);
    EXPECT_EQ(other.needed, one.needed);
    EXPECT_EQ(other.hits.mean(), one.hits.mean());
  }
}

TEST(ConditionCampaign, RejectsCountingOutOfRange) {
  ConditionOptions options = cell(380.0, 0.01);
  options.counting.window = 1;
  EXPECT_THROW(compute(options), std::invalid_argument);
  options = cell(380.0, 0.01);
  options.counting.count = 0;
  EXPECT_THROW(compute(options), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::campaign
