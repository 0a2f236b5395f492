// Table 2 in a short form: each of its cells at least as good as printed, by what outlets ship
// with.
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

ConditionResult play(const ConditionOptions& options, std::size_t threads = 2) {
  Execution execution;
  execution.threads = threads;
  return count_conditions(ieee24(), options, execution);
}

TEST(ConditionCampaign, WithoutNoiseALossAboveTheThresholdAloneIsShedFor) {
  EXPECT_EQ(play(cell(380.0, 0.0)).probability(), 1.0);
  EXPECT_EQ(play(cell(320.0, 0.0)).probability(), 0.0);
}

TEST(ConditionCampaign, EveryCellOfTable2IsAtLeastAsGoodAsPrinted) {
  // As many trajectories as let the printed figure be missed by eight of them.
  const ConditionResult rarely_missed = play(cell(380.0, 0.005, 1000000));
  EXPECT_GE(rarely_missed.probability(), 0.999992);
  EXPECT_NEAR(rarely_missed.hits.mean(), 36.85, 0.05);
  const ConditionResult noisy = play(cell(380.0, 0.010));
  EXPECT_GE(noisy.probability(), 0.978264);
  EXPECT_NEAR(noisy.hits.mean(), 30.56, 0.15);
  EXPECT_LE(play(cell(320.0, 0.005)).probability(), 0.001029);
  EXPECT_LE(play(cell(320.0, 0.010)).probability(), 0.117682);
}

// Mutants of the shipped setting, which the limits above must see.
TEST(ConditionCampaign, AHigherOrLowerCountOfHitsIsWorseThanPrinted) {
  ConditionOptions mutant = cell(380.0, 0.005);
  mutant.counting.more_than = 30;
  EXPECT_LT(play(mutant).probability(), 0.999);
  mutant = cell(320.0, 0.010);
  mutant.counting.more_than = 15;
  EXPECT_GT(play(mutant).probability(), 0.3);
  mutant.noise_hz = 0.005;
  EXPECT_GT(play(mutant).probability(), 0.01);
}

TEST(ConditionCampaign, IsTheSameOnAnyNumberOfThreads) {
  const ConditionResult one = play(cell(320.0, 0.01), 1);
  for (const std::size_t threads : {2U, 3U}) {
    const ConditionResult other = play(cell(320.0, 0.01), threads);
    EXPECT_EQ(other.needed, one.needed);
    EXPECT_EQ(other.hits.mean(), one.hits.mean());
  }
}

TEST(ConditionCampaign, RefusesWhatMakesNoSense) {
  ConditionOptions options = cell(380.0, 0.01);
  options.counting.window = 1;
  EXPECT_THROW(play(options), std::invalid_argument);
  options = cell(380.0, 0.01);
  options.counting.count = 0;
  EXPECT_THROW(play(options), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::campaign
