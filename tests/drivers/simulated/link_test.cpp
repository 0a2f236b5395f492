// What the simulated bench's link and relay sense add to what all do (tests/contracts).
#include "mains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::simulated::test {
namespace {

using gs::wire::UplinkKind;
using ::testing::HasSubstr;

TEST(SimulatedLink, FindsItsOutletsOnlyOnceTheSourceRuns) {
  Bench bench(bench_of(3));
  const auto before = bench.link().open();
  ASSERT_FALSE(before.ok());
  EXPECT_THAT(before.error(), HasSubstr("start the source first"));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  EXPECT_TRUE(bench.link().open().ok());
}

TEST(SimulatedLink, AMessageReachesItsOutletAfterTheDownlinksDelayAndNoOther) {
  for (const double downlink_ms : {0.0, 5.0, 20.0}) {
    BenchParameters parameters = bench_of(2);
    parameters.outlet.downlink_ms = downlink_ms;
    Bench bench(parameters);
    ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
    ASSERT_TRUE(bench.link().open().ok());
    const std::vector<float> voltage = falling_mains(0.5);
    ASSERT_TRUE(bench.source().play(0, voltage.data(), 805).ok());
    ASSERT_TRUE(bench.link().send(1, command(false)).ok());
    ASSERT_TRUE(bench.source().play(805, voltage.data() + 805, 3000).ok());
    std::vector<Heard> heard(2);
    poll(bench, heard);
    EXPECT_TRUE(heard[0].of(UplinkKind::kRelay).empty());
    ASSERT_EQ(heard[1].of(UplinkKind::kRelay).size(), 1U);
    EXPECT_EQ(heard[1].of(UplinkKind::kRelay)[0].sample,
              805U + static_cast<std::uint64_t>(8.0 * downlink_ms));
  }
}

TEST(SimulatedRelaySense, TellsAnEdgeOnlyOnceItsTickHasBeenPlayed) {
  BenchParameters parameters = bench_of(1);
  parameters.outlet.downlink_ms = 0.0;
  Bench bench(parameters);
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  ASSERT_TRUE(bench.link().open().ok());
  ASSERT_TRUE(bench.link().send(0, command(false)).ok());
  const std::vector<float> voltage = falling_mains(0.1);
  std::vector<Heard> heard(1);
  std::int64_t tick = 0;
  while (heard[0].edges.empty() && tick < 800) {
    ASSERT_TRUE(bench.source().play(tick, voltage.data() + tick, 1).ok());
    ++tick;
    poll(bench, heard);
  }
  ASSERT_EQ(heard[0].edges.size(), 1U);
  EXPECT_EQ(heard[0].edges[0].tick, tick - 1);
  EXPECT_FALSE(heard[0].edges[0].closed);
}

}  // namespace
}  // namespace gsbench::simulated::test
