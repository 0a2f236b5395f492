// When many outlets speak, each message by itself would wake the thread that receives: a change of
// threads, a look at the socket and an acknowledgement of TCP's cost more than the message does.
// While they come often, the thread therefore lets some gather. Seldom ones are taken at once, and
// what waits already is never made to wait longer.
#pragma once

#include <chrono>

namespace gsbench::link {

class Gathering {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr auto kPause = std::chrono::milliseconds(1);
  static constexpr auto kWindow = std::chrono::milliseconds(10);
  static constexpr int kOften = 50;  // messages in a window: 5000/s, as 80 outlets say
  // More than between two messages that lay in the socket together.
  static constexpr auto kWaitedFor = std::chrono::microseconds(40);

  // After each message has been dealt with: how long to look away from the socket, most often zero.
  Clock::duration pause_after_message(Clock::time_point now);
  // Once that is over.
  void resume(Clock::time_point now) { last_ = now; }

 private:
  Clock::time_point window_begin_;
  Clock::time_point last_;
  int count_ = 0;       // in this window
  int count_last_ = 0;  // in the one before
};

}  // namespace gsbench::link
