#include <thread>

#include <simulated/pacer.hpp>

namespace gsbench::simulated {

void Pacer::start(std::int64_t sample_rate_hz) {
  sample_rate_hz_ = sample_rate_hz;
  started_ = std::chrono::steady_clock::now();
}

void Pacer::wait_until(std::int64_t tick) const {
  if (pace_ == Pace::kVirtual) {
    return;
  }
  const std::int64_t whole_seconds = tick / sample_rate_hz_;
  const std::int64_t rest_ns = (tick % sample_rate_hz_) * 1'000'000'000 / sample_rate_hz_;
  std::this_thread::sleep_until(started_ + std::chrono::seconds(whole_seconds) +
                                std::chrono::nanoseconds(rest_ns));
}

}  // namespace gsbench::simulated
