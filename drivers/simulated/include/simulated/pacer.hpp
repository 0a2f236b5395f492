// Virtual time runs as fast as the machine can; real time holds the same code back to the wall
// clock.
#pragma once

#include <chrono>
#include <cstdint>

namespace gsbench::simulated {

enum class Pace { kVirtual, kRealTime };

class Pacer {
 public:
  explicit Pacer(Pace pace) : pace_(pace) {}
  // Tick 0 is now.
  void start(std::int64_t sample_rate_hz);
  // Returns when the wall clock has reached the tick.
  void wait_until(std::int64_t tick) const;

 private:
  Pace pace_;
  std::int64_t sample_rate_hz_ = 1;
  std::chrono::steady_clock::time_point started_;
};

}  // namespace gsbench::simulated
