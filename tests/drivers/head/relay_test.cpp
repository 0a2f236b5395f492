// The relay sense of a head: edges on the clock of its samples.
#include <head_driver_test/head_rig.hpp>

#include <random>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

constexpr double kCrystal_ppm = -150.0;

class HeadRelay : public testing::Test {
 protected:
  HeadRelay() : rig_(HeadPace::kAsFed, crystal()) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      rig_.head->set_input(channel, 0, true);
    }
  }
  static emulation::HeadEmulatorOptions crystal() {
    emulation::HeadEmulatorOptions options;
    options.clock_ppm = kCrystal_ppm;
    return options;
  }

  // Changes an input at the next step, and plays until the bench has seen its edges.
  std::int64_t set(std::size_t channel, bool closed) {
    const std::int64_t step = rig_.head.freeze();
    rig_.head->set_input(channel, step, closed);
    rig_.head.go_on();
    return step;
  }
  void play_on() {
    const auto played = rig_.source().advance(tick_ + 80);
    demand(played);
    tick_ = played.value();
  }
  // Plays until the bench has seen this many edges, for 1 s at most.
  std::vector<relay::Edge> polled(std::size_t wanted) {
    std::vector<relay::Edge> edges;
    for (const std::int64_t end = tick_ + 8000; edges.size() < wanted && tick_ < end;) {
      play_on();
      demand(rig_.relay_sense().poll(edges));
    }
    return edges;
  }
  // The exact tick of a step: by the emulator's own count.
  double tick_at(std::int64_t step) {
    const double codes = static_cast<double>(step) * (1.0 + 1e-6 * kCrystal_ppm) -
                         static_cast<double>(rig_.head->observe().stream_begin);
    return codes / 8.0 - static_cast<double>(rig_.tick_0_sample());
  }
  double exact_tick(const relay::Edge& edge) {
    const relay::Alignment alignment = rig_.relay_sense().alignment();
    return (static_cast<double>(edge.count) - alignment.count_at_tick_0) /
           alignment.counts_per_tick;
  }

  HeadRig rig_;
  Mains mains_;
  std::int64_t tick_ = 0;
};

TEST_F(HeadRelay, PutsAnEdgeOnTheSourcesClockToACount) {
  rig_.start(mains_);
  EXPECT_EQ(polled(1).size(), 1U) << "input 3 is open";
  for (int i = 0; i < 20; ++i) {
    const std::int64_t step = set(1, i % 2 == 1);
    const std::vector<relay::Edge> edges = polled(1);
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].channel, 1U);
    EXPECT_EQ(edges[0].closed, i % 2 == 1);
    // The emulated contact has no opto-coupler, whose delay the driver subtracts. One count is 95
    // millionths of a tick.
    const double delay_s =
        edges[0].closed ? rig_.options.opto_close_delay_s : rig_.options.opto_open_delay_s;
    EXPECT_NEAR(exact_tick(edges[0]), tick_at(step) - 8000.0 * delay_s, 1.5 / 10500.0);
  }
}

TEST_F(HeadRelay, ReportsAnOpenContactAsAnOpeningBeforeTheStimulus) {
  rig_.head->set_input(0, 0, false);
  rig_.start(mains_);
  const std::vector<relay::Edge> edges = polled(2);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].channel, 0U);
  EXPECT_EQ(edges[1].channel, 3U);
  for (const relay::Edge& edge : edges) {
    EXPECT_FALSE(edge.closed);
    EXPECT_LT(exact_tick(edge), -4000.0);
  }
}

TEST_F(HeadRelay, KeepsEdgesOfThePowerUpForTheStart) {
  ASSERT_TRUE(rig_.source().prepare(mains_).ok());
  ASSERT_TRUE(rig_.source().energise().ok());
  const std::int64_t step = set(2, false);
  std::vector<relay::Edge> edges;
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(rig_.source().hold().ok());
    ASSERT_TRUE(rig_.relay_sense().poll(edges).ok());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(edges.empty());
  ASSERT_TRUE(rig_.source().start().ok());
  edges = polled(2);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].channel, 3U);
  EXPECT_EQ(edges[1].channel, 2U);
  EXPECT_NEAR(exact_tick(edges[1]), tick_at(step), 0.3);
}

TEST_F(HeadRelay, LosesNoEdgeOnABadLine) {
  rig_.start(mains_);
  EXPECT_EQ(polled(1).size(), 1U);
  int lost = 0;
  rig_.head->spoil_to_bench(
      [&, random = std::mt19937(1)](std::vector<std::uint8_t>& frame) mutable {
        if (random() % 2 == 0) {
          ++lost;
          frame.clear();
        }
      });
  std::vector<double> wanted;
  std::vector<relay::Edge> edges;
  for (int i = 0; i < 15; ++i) {
    wanted.push_back(tick_at(set(0, i % 2 == 1)));
    for (int block = 0; block < 5; ++block) {
      play_on();
      demand(rig_.relay_sense().poll(edges));
    }
  }
  // The head keeps 64 edges, which can be asked for again: every 20 ms of the host's time, while
  // the head's time goes on as fast as it is fed.
  for (int block = 0; edges.size() < wanted.size() && block < 4000; ++block) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    play_on();
    demand(rig_.relay_sense().poll(edges));
  }
  // From here on, the head's thread no longer changes `lost`.
  rig_.head->spoil_to_bench({});
  ASSERT_EQ(edges.size(), wanted.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_NEAR(exact_tick(edges[i]), wanted[i], 0.3);
    EXPECT_EQ(edges[i].closed, i % 2 == 1);
  }
  EXPECT_GT(lost, 20);
}

TEST_F(HeadRelay, StatesItsUncertaintyFromTheOptoCoupler) {
  // Half a tick, one of 10 500 counts, and the opto-coupler's 20 µs.
  rig_.start(mains_);
  EXPECT_NEAR(rig_.relay_sense().alignment().uncertainty_ticks, 0.5 + 1.0 / 10500.0 + 0.16, 1e-9);
}

}  // namespace
}  // namespace gsbench::test
