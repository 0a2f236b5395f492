#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <models/relay_model.hpp>

namespace gsbench::models {
namespace {

constexpr std::int64_t kRate_hz = 8000;
constexpr std::int64_t kCoilTick = 1000;
constexpr std::uint64_t kChanges = 2000;
constexpr double kTicks_per_ms = 8.0;

const Stream kRelayStream{7, kTest, 0};

std::vector<ContactEdge> edges(std::uint64_t n, bool closes, const Stream& stream = kRelayStream,
                               const RelayParameters& parameters = {}) {
  return contact_edges(parameters, stream, n, kCoilTick, closes, kRate_hz);
}

bool same(const std::vector<ContactEdge>& a, const std::vector<ContactEdge>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ContactEdge& x, const ContactEdge& y) {
                      return x.tick == y.tick && x.closed == y.closed;
                    });
}

TEST(RelayModel, MovesTheContactWithinTheRangeOfOperateTimesAndUsesAllOfIt) {
  const RelayParameters p;
  double shortest_ms = 1e9;
  double longest_ms = 0.0;
  for (std::uint64_t n = 0; n < kChanges; ++n) {
    const double after_ms =
        static_cast<double>(edges(n, n % 2 == 0).front().tick - kCoilTick) / kTicks_per_ms;
    shortest_ms = std::min(shortest_ms, after_ms);
    longest_ms = std::max(longest_ms, after_ms);
  }
  const double half_tick_ms = 0.5 / kTicks_per_ms;
  EXPECT_GE(shortest_ms, p.operate_ms - p.operate_spread_ms - half_tick_ms);
  EXPECT_LE(longest_ms, p.operate_ms + p.operate_spread_ms + half_tick_ms);
  // The probability that none of 2000 uniform values is in the outer 2 % is 10⁻¹⁷.
  EXPECT_LT(shortest_ms, p.operate_ms - 0.96 * p.operate_spread_ms + half_tick_ms);
  EXPECT_GT(longest_ms, p.operate_ms + 0.96 * p.operate_spread_ms - half_tick_ms);
}

TEST(RelayModel, DoesNotBounceOnOpening) {
  for (std::uint64_t n = 0; n < kChanges; ++n) {
    const std::vector<ContactEdge> opening = edges(n, false);
    ASSERT_EQ(opening.size(), 1U);
    EXPECT_FALSE(opening[0].closed);
  }
}

TEST(RelayModel, BouncesOnClosingUpToTheLargestNumberAndEndsClosed) {
  const RelayParameters p;
  std::set<std::size_t> bounces;
  for (std::uint64_t n = 0; n < kChanges; ++n) {
    const std::vector<ContactEdge> closing = edges(n, true);
    ASSERT_EQ(closing.size() % 2, 1U);
    bounces.insert(closing.size() / 2);
    for (std::size_t i = 0; i < closing.size(); ++i) {
      EXPECT_EQ(closing[i].closed, i % 2 == 0);
      if (i > 0) {
        const std::int64_t gap = closing[i].tick - closing[i - 1].tick;
        EXPECT_GE(gap, 1);
        EXPECT_LE(gap, 1 + std::llround(p.bounce_ms * kTicks_per_ms));
      }
    }
  }
  EXPECT_EQ(bounces, (std::set<std::size_t>{0, 1, 2, 3}));
}

// Required by RelayParameters, also at the lowest sample rate, where a tick is a millisecond.
TEST(RelayModel, StopsBouncingBeforeTheNextOperationCanBegin) {
  const RelayParameters p;
  for (const std::int64_t rate_hz : {1000, 8000, 32000}) {
    for (std::uint64_t n = 0; n < kChanges; ++n) {
      const auto closing = contact_edges(p, kRelayStream, n, 0, true, rate_hz);
      const double bouncing_ms = 1e3 *
                                 static_cast<double>(closing.back().tick - closing.front().tick) /
                                 static_cast<double>(rate_hz);
      ASSERT_LT(bouncing_ms, p.operate_ms - p.operate_spread_ms);
    }
  }
}

TEST(RelayModel, IsAPureFunctionOfItsArguments) {
  for (const bool closes : {false, true}) {
    const std::vector<ContactEdge> later = edges(9, closes);
    edges(3, !closes);
    EXPECT_TRUE(same(edges(9, closes), later));
  }
}

TEST(RelayModel, DiffersBetweenOperationsAndBetweenRelays) {
  const Stream other{kRelayStream.seed, kRelayStream.purpose, 1};
  int same_as_next = 0;
  int same_as_other = 0;
  for (std::uint64_t n = 0; n < 100; ++n) {
    same_as_next += same(edges(n, false), edges(n + 1, false)) ? 1 : 0;
    same_as_other += same(edges(n, false), edges(n, false, other)) ? 1 : 0;
  }
  // With a spread of 24 ticks, 4 of 100 agree by chance, with a standard deviation of 2.
  EXPECT_LT(same_as_next, 15);
  EXPECT_LT(same_as_other, 15);
}

TEST(RelayModel, FollowsItsParameters) {
  RelayParameters slow;
  slow.operate_ms = 20.0;
  slow.operate_spread_ms = 0.0;
  slow.largest_bounces = 0;
  for (std::uint64_t n = 0; n < 10; ++n) {
    EXPECT_TRUE(same(edges(n, true, kRelayStream, slow), {{kCoilTick + 160, true}}));
  }
}

}  // namespace
}  // namespace gsbench::models
