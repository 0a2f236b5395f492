// Table 2 in a short form: each of its cells at least as good as printed, by what outlets ship
// with.
#include <stdexcept>

#include <gtest/gtest.h>

#include <campaign/conditions.hpp>
#include <profile/load.hpp>

namespace {

using gsbench::campaign::ConditionOptions;
using gsbench::campaign::ConditionResult;
using gsbench::campaign::Execution;

const gsbench::grid::Grid& ieee24() {
  static const gsbench::grid::Grid grid = gsbench::profile::load_grid("ieee24");
  return grid;
}

ConditionOptions cell(double loss_mw, double noise_hz) {
  ConditionOptions options;
  options.loss_mw = loss_mw;
  options.noise_hz = noise_hz;
  options.counting = gsbench::campaign::shipped_counting(ieee24());
  options.trajectories = 20000;
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
  EXPECT_GE(play(cell(380.0, 0.005)).probability(), 0.999992);
  EXPECT_GE(play(cell(380.0, 0.010)).probability(), 0.978264);
  EXPECT_LE(play(cell(320.0, 0.005)).probability(), 0.001029);
  EXPECT_LE(play(cell(320.0, 0.010)).probability(), 0.117682);
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
