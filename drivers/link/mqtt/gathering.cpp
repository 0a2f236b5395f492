#include "gathering.hpp"

namespace gsbench::link {

Gathering::Clock::duration Gathering::pause_after_message(Clock::time_point now) {
  const auto into_window = now - window_begin_;
  if (into_window >= kWindow) {
    count_last_ = into_window < 2 * kWindow ? count_ : 0;
    count_ = 0;
    window_begin_ = now;
  }
  ++count_;
  const bool waited_for = now - last_ > kWaitedFor;
  last_ = now;
  return waited_for && (count_ >= kOften || count_last_ >= kOften) ? kPause : Clock::duration(0);
}

}  // namespace gsbench::link
