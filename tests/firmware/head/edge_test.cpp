#include <head_test/rig.hpp>

#include <gtest/gtest.h>

#include <head/count64.hpp>

namespace gs::head::test {
namespace {

TEST(Edges, HaveTheCountSinceSample0ToTheCount) {
  Rig rig;
  rig.run_ms(7);
  rig.play(4096);
  const std::uint64_t begin = rig.now();
  rig.run_ms(1);
  rig.head().edge(2, true, begin + 12345);
  rig.head().edge(0, true, begin + 12346);
  rig.head().edge(2, false, begin + 20000);
  rig.receive();
  const auto edges = rig.received<Edge>();
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[0].edge, 0U);
  EXPECT_EQ(edges[0].input, 2);
  EXPECT_TRUE(edges[0].closed);
  EXPECT_EQ(edges[0].count, 12345);
  EXPECT_EQ(edges[1].edge, 1U);
  EXPECT_EQ(edges[1].input, 0);
  EXPECT_EQ(edges[1].count, 12346);
  EXPECT_EQ(edges[2].edge, 2U);
  EXPECT_FALSE(edges[2].closed);
  EXPECT_EQ(edges[2].count, 20000);
  EXPECT_EQ(rig.status().edges, 3U);
  EXPECT_EQ(rig.status().closed, 1U);
}

TEST(Edges, ShortlyBeforeSample0HaveANegativeCount) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(1);
  Rig later;
  later.run_ms(100);
  later.play(4096);
  const std::uint64_t begin = later.now();
  later.make_codes(kBlockCodes);
  later.head().edge(1, true, begin - 50);
  later.receive();
  ASSERT_EQ(later.received<Edge>().size(), 1U);
  EXPECT_EQ(later.received<Edge>()[0].count, -50);
}

TEST(Edges, BeforeAStreamChangeTheStateOnly) {
  Rig rig;
  rig.head().edge(3, true, 0);
  rig.arm();
  rig.head().edge(1, true, 500);
  rig.receive();
  EXPECT_TRUE(rig.received<Edge>().empty());
  EXPECT_EQ(rig.status().closed, 0b1010U);
  EXPECT_EQ(rig.status().edges, 0U);
}

// A relay that falls out because the voltage is off is a result as well.
TEST(Edges, AreReportedAfterTheStreamUntilTheNextArm) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(2);
  rig.send(Stop{});
  rig.run_ms(3);
  rig.head().edge(0, true, rig.now());
  rig.receive();
  ASSERT_EQ(rig.received<Edge>().size(), 1U);
  EXPECT_EQ(rig.received<Edge>()[0].count, 5 * 8 * std::int64_t{kCountsPerSample});
  rig.send(Arm{8});
  rig.head().edge(0, false, rig.now());
  rig.forget();
  EXPECT_EQ(rig.status().edges, 0U);
  EXPECT_TRUE(rig.received<Edge>().empty());
  EXPECT_EQ(rig.status().closed, 0U);
}

TEST(Edges, AreSentAgainOnRequest) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(1);
  for (std::uint32_t i = 0; i < 5; ++i) {
    rig.head().edge(0, i % 2 == 0, 100000 + i);
  }
  rig.receive();
  const auto first = rig.received<Edge>();
  rig.forget();
  rig.send(ResendEdges{2});
  rig.receive();
  const auto again = rig.received<Edge>();
  ASSERT_EQ(first.size(), 5U);
  ASSERT_EQ(again.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again[i].edge, i + 2);
    EXPECT_EQ(again[i].count, first[i + 2].count);
    EXPECT_EQ(again[i].closed, first[i + 2].closed);
  }
  rig.forget();
  rig.send(ResendEdges{5});  // none is missing
  rig.receive();
  EXPECT_TRUE(rig.received<Edge>().empty());
  EXPECT_TRUE(rig.received<Refused>().empty());
}

TEST(Edges, OfWhichOnlyTheNewestAreKept) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(1);
  for (std::uint32_t i = 0; i < 100; ++i) {
    rig.head().edge(0, i % 2 == 0, 1000 + i);
  }
  rig.receive();
  const auto edges = rig.received<Edge>();
  ASSERT_EQ(edges.size(), kKeptEdges);
  EXPECT_EQ(edges.front().edge, 36U);
  EXPECT_EQ(edges.back().edge, 99U);
  EXPECT_EQ(rig.status().edges, 100U);
  EXPECT_EQ(rig.status().edges_missed, 36U);
  rig.forget();
  rig.send(ResendEdges{35}, rig.number());
  rig.receive();
  ASSERT_EQ(rig.received<Refused>().size(), 1U);
  EXPECT_EQ(rig.received<Refused>()[0].reason, Refusal::kNotKept);
  rig.forget();
  rig.send(ResendEdges{36});
  rig.receive();
  EXPECT_EQ(rig.received<Edge>().size(), kKeptEdges);
}

TEST(Edges, MissedByTheBoardAreCounted) {
  Rig rig;
  rig.head().edges_missed(2);
  rig.head().edges_missed(1);
  EXPECT_EQ(rig.status().edges_missed, 3U);
}

TEST(Count64, ExtendsATimerAcrossItsOverflows) {
  Count64 count;
  std::uint64_t exact = 0;
  for (int ms = 0; ms < 200000; ++ms) {
    exact += 84000;
    count.advance(static_cast<std::uint32_t>(exact));
    for (const std::int64_t offset : {-83999, -1, 0, 1, 83999}) {
      const std::uint64_t wanted = exact + static_cast<std::uint64_t>(offset);
      ASSERT_EQ(count.extend(static_cast<std::uint32_t>(wanted)), wanted);
    }
  }
  EXPECT_GT(exact, 3ULL << 32U);
}

TEST(Count64, DoesNotGoBelowStartUp) {
  Count64 count;
  EXPECT_EQ(count.extend(0xFFFFFFF0U), 0U);
  count.advance(100);
  EXPECT_EQ(count.extend(50), 50U);
  EXPECT_EQ(count.extend(0xFFFFFFF0U), 0U);
}

TEST(Edges, HaveExactCountsAcrossAnOverflowOfTheTimer) {
  Rig rig;
  Count64 count;
  // Each sample and edge has the count that the board would measure, from 32 bits.
  constexpr std::uint64_t kStart = (1ULL << 32U) - 42000;  // overflows in the first millisecond
  for (std::uint64_t at = 0; at < kStart; at += 1U << 30U) {
    count.advance(static_cast<std::uint32_t>(at));
  }
  rig.play(256);
  std::vector<std::uint16_t> codes(kBlockCodes);
  count.advance(static_cast<std::uint32_t>(kStart));
  rig.head().next_codes(kStart, codes.data(), codes.size());
  rig.head().edge(0, true, count.extend(static_cast<std::uint32_t>(kStart + 41999)));
  rig.head().edge(0, false, count.extend(static_cast<std::uint32_t>(kStart + 42001)));
  count.advance(static_cast<std::uint32_t>(kStart + 84000));
  rig.head().edge(0, true, count.extend(static_cast<std::uint32_t>(kStart + 41999)));
  rig.receive();
  const auto edges = rig.received<Edge>();
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[0].count, 41999);
  EXPECT_EQ(edges[1].count, 42001);
  EXPECT_EQ(edges[2].count, 41999);
}

}  // namespace
}  // namespace gs::head::test
