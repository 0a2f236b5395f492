// The contact of a simulated outlet and its coil.

#include "mains.hpp"

#include <utility>

#include <simulated/outlet.hpp>

namespace gsbench::simulated::test {
namespace {

using Edges = std::vector<std::pair<std::int64_t, bool>>;

// The contact's edges if the coil changes at these ticks: off first, then on, and so on.
Edges contact_after(const std::vector<std::int64_t>& coil_ticks, std::size_t block_ticks = 4000) {
  OutletParameters parameters;
  parameters.downlink_ms = 0.0;
  parameters.relay.operate_ms = 8.0;  // 64 ticks
  parameters.relay.operate_spread_ms = 0.0;
  parameters.relay.largest_bounces = 0;
  Outlet outlet(parameters, "outlet", 0);
  EXPECT_TRUE(outlet.start(kRate_hz, 50, 0.0F, 1));
  bool close = false;
  for (const std::int64_t tick : coil_ticks) {
    outlet.send(tick, command(close));
    close = !close;
  }
  const gsbench::test::Mains mains = falling_mains(0.5);
  std::vector<float> voltage(static_cast<std::size_t>(mains.total_ticks()));
  mains.render(0, voltage.size(), voltage.data());
  std::vector<models::ContactEdge> edges;
  std::vector<gs::wire::Uplink> messages;
  for (std::size_t tick = 0; tick < voltage.size(); tick += block_ticks) {
    const std::size_t count = std::min(block_ticks, voltage.size() - tick);
    outlet.feed(static_cast<std::int64_t>(tick), voltage.data() + tick, count);
    outlet.take_edges(edges, static_cast<std::int64_t>(tick + count));
    outlet.take_messages(messages);
  }
  std::size_t turns = 0;
  for (const gs::wire::Uplink& message : messages) {
    turns += message.kind == gs::wire::UplinkKind::kRelay ? 1 : 0;
  }
  EXPECT_EQ(turns, coil_ticks.size()) << "the outlet must report each change of its coil";
  EXPECT_EQ(outlet.relay_closed(), coil_ticks.size() % 2 == 0);
  Edges seen;
  for (const models::ContactEdge& edge : edges) {
    seen.emplace_back(edge.tick, edge.closed);
  }
  return seen;
}

TEST(SimulatedContact, FollowsTheCoilAfterTheOperateTime) {
  EXPECT_EQ(contact_after({1000, 2000}), (Edges{{1064, false}, {2064, true}}));
}

TEST(SimulatedContact, DoesNotMoveIfTheCoilReturnsBeforeTheOperateTime) {
  EXPECT_EQ(contact_after({1000, 1001}), Edges{});
  EXPECT_EQ(contact_after({1000, 1063}), Edges{});
}

TEST(SimulatedContact, MovesTwiceIfTheCoilReturnsAfterTheOperateTime) {
  EXPECT_EQ(contact_after({1000, 1064}), (Edges{{1064, false}, {1128, true}}));
}

TEST(SimulatedContact, MovesAgainAfterACancelledChange) {
  EXPECT_EQ(contact_after({1000, 1030, 1040}), (Edges{{1104, false}}));
  EXPECT_EQ(contact_after({1000, 1030, 1040, 1050, 2000}), (Edges{{2064, false}}));
}

TEST(SimulatedContact, DoesNotMoveForTwoChangesAtTheSameTick) {
  EXPECT_EQ(contact_after({1000, 1000}), Edges{});
}

TEST(SimulatedContact, DoesNotDependOnTheBlockSize) {
  const std::vector<std::int64_t> turns = {500, 540, 1000, 1064, 1500, 1501, 1502};
  const Edges whole = contact_after(turns);
  ASSERT_EQ(whole, (Edges{{1064, false}, {1128, true}, {1566, false}}));
  for (const std::size_t block_ticks : {1U, 7U, 64U, 128U, 1000U}) {
    EXPECT_EQ(contact_after(turns, block_ticks), whole) << block_ticks;
  }
}

}  // namespace
}  // namespace gsbench::simulated::test
