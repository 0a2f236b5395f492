#include "mains.hpp"

#include <chrono>

#include <simulated/pacer.hpp>

namespace gsbench::simulated::test {
namespace {

using Clock = std::chrono::steady_clock;

// Lower bounds only: a busy machine may wake up late.
TEST(Pacer, WaitsForTheWallClockInRealTime) {
  Pacer pacer(Pace::kRealTime);
  const auto before = Clock::now();
  pacer.start(kRate_hz);
  pacer.wait_until(1600);
  EXPECT_GE(Clock::now() - before, std::chrono::milliseconds(200));
}

TEST(Pacer, CountsFromItsLatestStart) {
  Pacer pacer(Pace::kRealTime);
  pacer.start(kRate_hz);
  pacer.wait_until(400);
  const auto before = Clock::now();
  pacer.start(kRate_hz);
  pacer.wait_until(400);
  EXPECT_GE(Clock::now() - before, std::chrono::milliseconds(50));
}

TEST(Pacer, DoesNotWaitInVirtualTime) {
  Pacer pacer(Pace::kVirtual);
  const auto before = Clock::now();
  pacer.start(kRate_hz);
  pacer.wait_until(3600 * kRate_hz);
  EXPECT_LT(Clock::now() - before, std::chrono::hours(1));
}

TEST(Pacer, RealTimeGivesTheSameResultAsVirtualTime) {
  const gsbench::test::Mains mains = falling_mains(0.2 + 0.016, 0.01F);
  BenchParameters parameters = bench_of(2);
  Bench virtual_time(parameters);
  parameters.pace = Pace::kRealTime;
  Bench real_time(parameters);
  const auto fast = play(virtual_time, 2, mains, {128});
  const auto before = Clock::now();
  const auto slow = play(real_time, 2, mains, {128});
  // The last block is played when the one before it has ended.
  EXPECT_GE(Clock::now() - before, std::chrono::milliseconds(200 - 8));
  EXPECT_EQ(fast[0].as_bytes(), slow[0].as_bytes());
  EXPECT_EQ(fast[1].as_bytes(), slow[1].as_bytes());
}

}  // namespace
}  // namespace gsbench::simulated::test
