// The contract suite of relay senses. A new driver needs a rig and a line below.
#include "rigs.hpp"

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

// Longest time from coil to contact, bounces included.
constexpr std::int64_t kSlowestTicks = 160;

class AnyRelaySense : public testing::TestWithParam<std::unique_ptr<RelayRig> (*)()> {
 protected:
  AnyRelaySense() { play(4000); }

  void play(std::int64_t ticks) {
    tick_ += ticks;
    rig_->advance(tick_);
  }
  std::vector<relay::Edge> polled() {
    std::vector<relay::Edge> edges;
    const auto status = rig_->sense().poll(edges);
    EXPECT_TRUE(status.ok()) << status.error();
    return edges;
  }
  double tick_of(const relay::Edge& edge) {
    return static_cast<double>(rig_->sense().alignment().tick_of(edge.count));
  }
  double uncertainty_ticks() { return rig_->sense().alignment().uncertainty_ticks; }

  std::unique_ptr<RelayRig> rig_ = GetParam()();
  std::int64_t tick_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Simulated, AnyRelaySense, testing::Values(&simulated_sense));
INSTANTIATE_TEST_SUITE_P(Emulated, AnyRelaySense, testing::Values(&emulated_sense));
INSTANTIATE_TEST_SUITE_P(Head, AnyRelaySense, testing::Values(&head_sense));
INSTANTIATE_TEST_SUITE_P(Counter, AnyRelaySense, testing::Values(&counter_sense));
INSTANTIATE_TEST_SUITE_P(ModemLine, AnyRelaySense,
                         testing::Values(&modem_line_sense, &modem_line_sense_of_a_generator));
INSTANTIATE_TEST_SUITE_P(Terminals, AnyRelaySense, testing::Values(&terminal_sense));

TEST_P(AnyRelaySense, ReportsAnOpeningOnceByChannelAndTick) {
  EXPECT_TRUE(polled().empty());
  EXPECT_GT(uncertainty_ticks(), 0.0);
  EXPECT_LT(uncertainty_ticks(), rig_->most_uncertain_ticks());
  for (const std::size_t channel : {1U, 0U}) {
    const auto turned = static_cast<double>(tick_);
    rig_->turn(channel, false);
    play(2 * kSlowestTicks);
    const std::vector<relay::Edge> edges = polled();
    ASSERT_EQ(edges.size(), 1U) << "an opening contact does not bounce";
    EXPECT_EQ(edges[0].channel, channel);
    EXPECT_FALSE(edges[0].closed);
    EXPECT_GE(tick_of(edges[0]), turned - uncertainty_ticks());
    EXPECT_LE(tick_of(edges[0]), turned + kSlowestTicks + uncertainty_ticks());
    EXPECT_TRUE(polled().empty());
  }
}

TEST_P(AnyRelaySense, ReportsEdgesNeitherEarlyNorLate) {
  rig_->turn(0, false);
  EXPECT_TRUE(polled().empty());
  std::vector<relay::Edge> edges;
  for (int i = 0; edges.empty() && i < kSlowestTicks; ++i) {
    play(2);
    edges = polled();
  }
  ASSERT_FALSE(edges.empty());
  EXPECT_LE(tick_of(edges[0]), static_cast<double>(tick_) + uncertainty_ticks());
  // Not late either.
  EXPECT_GE(tick_of(edges[0]), static_cast<double>(tick_) - rig_->most_uncertain_ticks());
}

TEST_P(AnyRelaySense, ReportsAllEdgesInOrderIncludingBounces) {
  std::vector<relay::Edge> all;
  for (const bool closed : {false, true, false, true, false}) {
    rig_->turn(1, closed);
    play(2 * kSlowestTicks);
    const std::vector<relay::Edge> edges = polled();
    ASSERT_FALSE(edges.empty());
    EXPECT_EQ(edges.back().closed, closed);
    all.insert(all.end(), edges.begin(), edges.end());
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GT(all[i].count, all[i - 1].count);
    EXPECT_NE(all[i].closed, all[i - 1].closed);
  }
}

}  // namespace
}  // namespace gsbench::test
