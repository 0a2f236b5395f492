// The head's clock on the host's, from arrivals that are late by random delays.
#include "host_clock.hpp"

#include <random>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using Clock = std::chrono::steady_clock;

class HeadHostClock : public testing::Test {
 protected:
  static constexpr double kTick_s = 1.0 / 8000.0;
  static constexpr double kShortest_s = 0.0004;

  static Clock::time_point at(double s) {
    return Clock::time_point(
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s)));
  }
  static double seconds(Clock::time_point time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
  }
  // Statuses every 8 ms from a head that is `ppm` fast, each late by 0.2 ms and up to 20 ms more.
  void pass(double until_s) {
    for (; head_s_ < until_s; head_s_ += 0.008) {
      const double late_s = 0.0002 + 0.02 * static_cast<double>(random_()) / std::mt19937::max();
      estimate_.add(head_s_, at(true_s(head_s_) + late_s));
    }
  }
  double true_s(double head_s) const { return 1000.0 + head_s / (1.0 + 1e-6 * ppm_); }
  void expect_within_its_uncertainty(double end_s) {
    const auto clock = estimate_.of_ticks(1.0, end_s, kTick_s, kShortest_s);
    ASSERT_TRUE(clock.has_value());
    for (const double s : {1.0, end_s}) {
      const double estimated_s = seconds(clock->tick_0) + clock->tick_s * (s - 1.0) / kTick_s;
      EXPECT_NEAR(estimated_s, true_s(s), clock->uncertainty_s) << s;
    }
    uncertainty_s_ = clock->uncertainty_s;
  }

  double ppm_ = 25.0;
  double head_s_ = 0.5;
  double uncertainty_s_ = 0.0;
  std::mt19937 random_{3};
  head::HostClockEstimate estimate_{30.0};
};

TEST_F(HeadHostClock, IsUnknownBeforeTheFirstStatus) {
  EXPECT_FALSE(estimate_.of_ticks(1.0, 2.0, kTick_s, kShortest_s).has_value());
}

TEST_F(HeadHostClock, IsWithinTheCrystalsAccuracyAtFirst) {
  pass(2.0);
  expect_within_its_uncertainty(61.0);
  // 130 ppm over a minute.
  EXPECT_GT(uncertainty_s_, 0.0075);
  EXPECT_LT(uncertainty_s_, 0.0085);
}

TEST_F(HeadHostClock, FollowsTheCrystalAfterSomeSeconds) {
  pass(60.0);
  expect_within_its_uncertainty(60.0);
  EXPECT_LT(uncertainty_s_, 0.0015);
  EXPECT_GT(uncertainty_s_, 0.0002);
}

}  // namespace
}  // namespace gsbench::test
