// Virtual time runs as fast as the machine allows; real time waits for the wall clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

namespace gsbench::simulated {

enum class Pace { kVirtual, kRealTime };

class Pacer {
 public:
  explicit Pacer(Pace pace) : pace_(pace) {}
  // Tick 0 is now.
  void start(std::int64_t sample_rate_hz) {
    sample_rate_hz_ = sample_rate_hz;
    started_ = std::chrono::steady_clock::now();
  }
  // Real time: blocks until the wall clock has reached the tick. Virtual time: returns at once.
  void wait_until(std::int64_t tick) const {
    if (pace_ == Pace::kVirtual) {
      return;
    }
    const std::int64_t whole_s = tick / sample_rate_hz_;
    const std::int64_t rest_ns = (tick % sample_rate_hz_) * 1'000'000'000 / sample_rate_hz_;
    std::this_thread::sleep_until(started_ + std::chrono::seconds(whole_s) +
                                  std::chrono::nanoseconds(rest_ns));
  }

 private:
  Pace pace_;
  std::int64_t sample_rate_hz_ = 1;
  std::chrono::steady_clock::time_point started_;
};

}  // namespace gsbench::simulated
