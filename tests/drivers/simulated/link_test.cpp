// Tests of the simulated link beyond the contract suites (tests/contracts).
#include "mains.hpp"

namespace gsbench::simulated::test {
namespace {

using gs::wire::UplinkKind;

TEST(SimulatedLink, OutletsJoinWhenTheSourceIsEnergised) {
  Bench bench(bench_of(3));
  link::Happenings happenings;
  ASSERT_TRUE(bench.link().open().ok());
  ASSERT_TRUE(bench.link().poll(happenings).ok());
  EXPECT_TRUE(happenings.changes.empty());
  const gsbench::test::Mains mains;
  ASSERT_TRUE(bench.source().prepare(mains).ok());
  ASSERT_TRUE(bench.source().energise().ok());
  ASSERT_TRUE(bench.link().poll(happenings).ok());
  EXPECT_EQ(happenings.changes.size(), 3U);
}

TEST(SimulatedLink, AMessageReachesOnlyItsOutletAfterTheDownlinkDelay) {
  for (const double downlink_ms : {0.0, 5.0, 20.0}) {
    BenchParameters parameters = bench_of(2);
    parameters.outlet.downlink_ms = downlink_ms;
    Bench bench(parameters);
    const gsbench::test::Mains mains;
    gsbench::test::start(bench.source(), mains);
    ASSERT_TRUE(bench.link().open().ok());
    gsbench::test::advance(bench.source(), 805);
    ASSERT_TRUE(bench.link().send(id_of(1), command(false)).ok());
    gsbench::test::advance(bench.source(), 805 + 3000);
    std::vector<OutletLog> logs(2);
    poll(bench, logs);
    EXPECT_TRUE(logs[0].of(UplinkKind::kRelay).empty());
    ASSERT_EQ(logs[1].of(UplinkKind::kRelay).size(), 1U);
    EXPECT_EQ(logs[1].of(UplinkKind::kRelay)[0].sample,
              805U + static_cast<std::uint64_t>(8.0 * downlink_ms));
  }
}

}  // namespace
}  // namespace gsbench::simulated::test
