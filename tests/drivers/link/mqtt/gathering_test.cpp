#include "gathering.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace {

using gsbench::link::Gathering;
using namespace std::chrono_literals;

class MessagesThatGather : public testing::Test {
 protected:
  struct Played {
    int pauses = 0;
    std::chrono::nanoseconds longest_delay{0};
  };

  // Messages reach the socket so long after one another; each takes the thread five microseconds.
  Played play(int messages, std::chrono::microseconds apart) {
    Played played;
    auto arrival = now_;
    for (int i = 0; i < messages; ++i) {
      arrival += apart;
      played.longest_delay =
          std::max<std::chrono::nanoseconds>(played.longest_delay, now_ - arrival);
      now_ = std::max(now_, arrival) + 5us;
      const auto pause = gathering_.pause_after_message(now_);
      if (pause > pause.zero()) {
        ++played.pauses;
        now_ += pause;
        gathering_.resume(now_);
      }
    }
    return played;
  }

  Gathering gathering_;
  Gathering::Clock::time_point now_ = Gathering::Clock::time_point(1h);
};

TEST_F(MessagesThatGather, SeldomOnesAreTakenAtOnce) {
  EXPECT_EQ(play(10000, 250us).pauses, 0);  // 4000 a second
  EXPECT_EQ(play(100, 1s).pauses, 0);
}

// 10 000 a second: some ten a pause, none later than the pause is long.
TEST_F(MessagesThatGather, FrequentOnesComeManyAtATime) {
  play(Gathering::kOften, 100us);
  const Played played = play(10000, 100us);
  EXPECT_GT(played.pauses, 500);
  EXPECT_LT(played.pauses, 1200);
  EXPECT_LE(played.longest_delay, Gathering::kPause);
}

TEST_F(MessagesThatGather, WhatWaitsAlreadyIsNeverMadeToWaitLonger) {
  play(1000, 5us);
  EXPECT_EQ(play(100000, 5us).pauses, 0);
}

TEST_F(MessagesThatGather, OnceTheyAreSeldomAgainTheyAreTakenAtOnce) {
  ASSERT_GT(play(1000, 100us).pauses, 0);
  now_ += 2 * Gathering::kWindow;
  EXPECT_EQ(play(Gathering::kOften - 1, 1ms).pauses, 0);
}

}  // namespace
