#include "mains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::simulated::test {
namespace {

using gs::wire::UplinkKind;
using ::testing::HasSubstr;

TEST(SimulatedLink, FindsTheOutletsInTheirOrderOnceTheSourceRuns) {
  Bench bench(bench_of(3));
  const auto before = bench.link().open();
  ASSERT_FALSE(before.ok());
  EXPECT_THAT(before.error(), HasSubstr("start the source first"));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  const auto present = bench.link().open();
  ASSERT_TRUE(present.ok());
  ASSERT_EQ(present.value().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(present.value()[i].id, "outlet-" + std::to_string(i + 1));
    EXPECT_EQ(present.value()[i].hello.protocol_version, gs::wire::kProtocolVersion);
    EXPECT_EQ(present.value()[i].hello.sample_rate_hz, kRateHz);
  }
}

TEST(SimulatedLink, RefusesToSendToAnOutletThatIsNotThere) {
  Bench bench(bench_of(2));
  const auto status = bench.link().send(2, command(false));
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), HasSubstr("no outlet 2"));
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

TEST(SimulatedLink, MessagesArriveInTheOrderTheyWereSent) {
  Bench bench(bench_of(1));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  ASSERT_TRUE(bench.link().open().ok());
  for (const bool close : {false, true, false}) {
    ASSERT_TRUE(bench.link().send(0, command(close)).ok());
  }
  const std::vector<float> voltage = falling_mains(0.1);
  ASSERT_TRUE(bench.source().play(0, voltage.data(), voltage.size()).ok());
  std::vector<Heard> heard(1);
  poll(bench, heard);
  const auto relay = heard[0].of(UplinkKind::kRelay);
  ASSERT_EQ(relay.size(), 3U);
  EXPECT_FALSE(relay[0].relay.closed);
  EXPECT_TRUE(relay[1].relay.closed);
  EXPECT_FALSE(relay[2].relay.closed);
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
