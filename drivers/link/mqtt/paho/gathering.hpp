// When many outlets speak, each message by itself would wake the thread that receives: a change of
// threads, a look at the socket and an acknowledgement of TCP's cost more than the message does.
// While they come often, the thread therefore lets some gather before it waits for the next. It
// never does so while anything is there, and seldom messages are taken at once.
#pragma once

#include <chrono>

namespace gsbench::link {

class Gathering {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr auto kPause = std::chrono::milliseconds(1);
  static constexpr auto kWindow = std::chrono::milliseconds(10);
  static constexpr int kOften = 50;  // messages in a window: 5000/s, as 80 outlets say

  void count_message() { ++count_; }
  // With nothing left to receive: how long to look away, most often not at all.
  Clock::duration pause_before_waiting(Clock::time_point now) {
    const auto into_window = now - window_begin_;
    if (into_window >= kWindow) {
      count_last_ = into_window < 2 * kWindow ? count_ : 0;
      count_ = 0;
      window_begin_ = now;
    }
    return count_ >= kOften || count_last_ >= kOften ? kPause : Clock::duration(0);
  }

 private:
  Clock::time_point window_begin_;
  int count_ = 0;       // in this window
  int count_last_ = 0;  // in the one before
};

}  // namespace gsbench::link
