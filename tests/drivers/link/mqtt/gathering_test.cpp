#include "gathering.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace {

using gsbench::link::Gathering;
using namespace std::chrono_literals;

// The thread that receives, as Paho's: it takes what is there, and with nothing there it waits.
class MessagesThatGather : public testing::Test {
 protected:
  struct Played {
    int waits = 0;
    std::chrono::nanoseconds longest_delay{0};
  };

  // Messages reach the socket so long after one another, and each takes the thread so long.
  Played play(int messages, std::chrono::microseconds apart, std::chrono::microseconds cost = 5us) {
    Played played;
    auto arrival = now_ + apart;
    for (int i = 0; i < messages; ++i, arrival += apart) {
      if (arrival > now_) {
        ++played.waits;
        now_ = std::max(arrival, now_ + gathering_.pause_before_waiting(now_));
      }
      played.longest_delay =
          std::max<std::chrono::nanoseconds>(played.longest_delay, now_ - arrival);
      gathering_.count_message();
      now_ += cost;
    }
    return played;
  }

  Gathering gathering_;
  Gathering::Clock::time_point now_ = Gathering::Clock::time_point(1h);
};

TEST_F(MessagesThatGather, SeldomOnesAreTakenAtOnce) {
  EXPECT_EQ(play(10000, 250us).longest_delay, 0ns);  // 4000 a second
  EXPECT_EQ(play(100, 1s).longest_delay, 0ns);
}

// 10 000 a second: some ten at a time, none much later than the pause is long.
TEST_F(MessagesThatGather, FrequentOnesComeManyAtATime) {
  play(Gathering::kOften, 100us);
  const Played played = play(10000, 100us);
  EXPECT_GT(played.waits, 500);
  EXPECT_LT(played.waits, 1500);
  EXPECT_LE(played.longest_delay, 2 * Gathering::kPause);
}

// However slow the machine: a queue is never made longer.
TEST_F(MessagesThatGather, WhatIsThereIsTakenWhateverAMessageCosts) {
  for (const auto cost : {5us, 39us, 41us, 100us}) {
    EXPECT_LE(play(20000, 2 * cost, cost).longest_delay, 3 * Gathering::kPause) << cost.count();
  }
}

TEST_F(MessagesThatGather, OnceTheyAreSeldomAgainTheyAreTakenAtOnce) {
  ASSERT_GT(play(1000, 100us).longest_delay, 0ns);
  now_ += 2 * Gathering::kWindow;
  EXPECT_EQ(play(Gathering::kOften - 1, 1ms).longest_delay, 0ns);
}

}  // namespace
