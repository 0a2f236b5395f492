// SIGKILL of the bench while it streams to a head, at random instants while it energises, holds and
// plays. The output is off within 250 ms of the last message, counted in the head's own codes, each
// time. Several heads at once, each with a bench of its own.
#include <head_driver_test/running_head.hpp>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <random>

#include <gmock/gmock.h>

#include <emulation/child.hpp>

namespace gsbench::test {
namespace {

using emulation::Child;

constexpr int kKills = KILLS;
constexpr int kHeads = 10;
constexpr std::int64_t kCodes_per_ms = 64;
constexpr std::int64_t kLatestOff = 250 * kCodes_per_ms;
// Samples of the stream. The ramp takes 4000; after 0.3 s and what is sent ahead, the stimulus
// begins.
constexpr std::int64_t kRampEnds = 4000;
constexpr std::int64_t kStimulusBegins = 7800;
constexpr std::int64_t kLastKill = 12000;
// One kill in this many is at a random instant of the first 40 ms, mostly before the stream.
constexpr int kEarly = 10;
constexpr unsigned kEarly_us = 40000;

struct Kill {
  std::int64_t played = 0;        // samples, when the last message arrived; < 0: not begun
  std::int64_t driven_codes = 0;  // after the last message; ≤ 0: the output was off
};

// Codes from the last message to the last one that is not mid-scale, once no more can come.
Kill result_of(RunningHead& head) {
  const auto over = [&] {
    const auto seen = head->observe();
    return seen.code - seen.last_frame > kLatestOff + 1000;
  };
  EXPECT_TRUE(until(over));
  const auto seen = head->observe();
  return {seen.stream_begin < 0 ? -1 : (seen.last_frame - seen.stream_begin) / 8,
          seen.last_driven - seen.last_frame};
}

// Kills a bench after `samples` of the stream, or < 0: after −samples µs. Returns false if the
// bench ended by itself.
bool kill_a_bench(RunningHead& head, std::int64_t samples) {
  auto started = Child::start({{HEAD_PLAYER_PROGRAM, head->port()}, ""});
  EXPECT_TRUE(started.ok());
  Child bench = started.take();
  if (samples < 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(-samples));
  }
  const auto is_time = [&] {
    const auto seen = head->observe();
    return !bench.running() ||
           (seen.stream_begin >= 0 && seen.code >= seen.stream_begin + 8 * samples);
  };
  EXPECT_TRUE(samples < 0 || until(is_time));
  const bool was_running = bench.running();
  bench.kill();
  return was_running;
}

TEST(KilledBench, LeavesTheOutputOffWithin250Ms) {
  std::atomic<int> left{kKills};
  std::atomic<int> ended_early{0};
  std::mutex mutex;
  std::vector<Kill> kills;
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < kHeads; ++i) {
    threads.emplace_back([&, i] {
      std::mt19937 random(i);
      for (int kill = --left; kill >= 0; kill = --left) {
        // A new head each time: its codes count from the beginning.
        RunningHead head(HeadPace::kRealTime);
        // Random within the kill's own part of the stream, so that every phase gets its share.
        const double part = static_cast<double>(random()) / std::mt19937::max();
        const std::int64_t samples =
            kill % kEarly == 0
                ? -static_cast<std::int64_t>(random() % kEarly_us)
                : static_cast<std::int64_t>(kLastKill * (kill % kKills + part) / kKills);
        if (!kill_a_bench(head, samples) && ended_early++ < kKills / 4) {
          ++left;  // on a machine that is too slow: it does not count
          continue;
        }
        const Kill result = result_of(head);
        const std::lock_guard<std::mutex> lock(mutex);
        kills.push_back(result);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }

  ASSERT_EQ(kills.size(), std::size_t{kKills});
  const auto during = [&](std::int64_t from, std::int64_t until) {
    return std::count_if(kills.begin(), kills.end(), [&](const Kill& kill) {
      return kill.played >= from && kill.played < until;
    });
  };
  const auto ramp = during(0, kRampEnds);
  const auto hold = during(kRampEnds, kStimulusBegins);
  const auto play = during(kStimulusBegins, std::int64_t{1} << 60);
  const auto slowest = std::max_element(
      kills.begin(), kills.end(),
      [](const Kill& a, const Kill& b) { return a.driven_codes < b.driven_codes; });
  const double slowest_ms = static_cast<double>(slowest->driven_codes) / kCodes_per_ms;
  std::printf(
      "%d kills: %td before the output, %td in the ramp, %td in hold, %td in play; output "
      "off %.1f ms after the last message at the latest\n",
      kKills, kKills - ramp - hold - play, ramp, hold, play, slowest_ms);
  EXPECT_LE(slowest_ms, 250.0);
  // What was sent ahead is still played.
  EXPECT_GE(slowest_ms, 50.0);
  EXPECT_GE(ramp, kKills / 10);
  EXPECT_GE(hold, kKills / 10);
  EXPECT_GE(play, kKills / 10);
}

}  // namespace
}  // namespace gsbench::test
