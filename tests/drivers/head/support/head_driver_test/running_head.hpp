// An emulated head whose time goes on, in a thread of its own.
#pragma once

#include <head_driver/head.hpp>
#include <test_support/waiting.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <emulation/head_emulator.hpp>
#include <emulation/output.hpp>

namespace gsbench::test {

enum class HeadPace {
  kRealTime,
  // While it plays, as fast as the machine allows, but it waits for the bench instead of running
  // out of samples. Otherwise real time.
  kAsFed
};

class RunningHead {
 public:
  // Gets the output, V, from this object's thread.
  using Sink = std::function<void(std::int64_t first_step, const float* volts, std::size_t count)>;

  explicit RunningHead(HeadPace pace = HeadPace::kAsFed,
                       const emulation::HeadEmulatorOptions& options = {}, Sink sink = {})
      : emulator_(emulation::HeadEmulator::create(options).take()),
        pace_(pace),
        sink_(std::move(sink)),
        thread_([this] { run(); }) {}
  ~RunningHead() {
    ending_ = true;
    thread_.join();
  }
  RunningHead(const RunningHead&) = delete;
  RunningHead& operator=(const RunningHead&) = delete;

  emulation::HeadEmulator& operator*() { return *emulator_; }
  emulation::HeadEmulator* operator->() { return emulator_.get(); }

  // The true time reached; from now on it does not go on beyond `step`.
  std::int64_t step() const { return step_; }
  void stop_at(std::int64_t step) { limit_ = step; }
  // Blocks until the time has stopped. Returns it.
  std::int64_t freeze() {
    limit_ = 0;
    while (!waiting_) {
      std::this_thread::yield();
    }
    return step_;
  }
  void go_on() { limit_ = kNever; }

 private:
  static constexpr std::int64_t kNever = std::int64_t{1} << 60;
  static constexpr std::int64_t kAtOnce = 32;  // steps, 0.5 ms
  static constexpr std::size_t kReserve = 64;  // samples

  void run() {
    std::vector<float> volts(kAtOnce);
    emulation::TrueTime time;
    while (!ending_) {
      const std::int64_t most = std::min<std::int64_t>(kAtOnce, limit_ - step_);
      waiting_ = most <= 0;
      if (most <= 0 || !may_go_on(time)) {
        std::this_thread::sleep_for(std::chrono::microseconds(waiting_ ? 200 : 100));
        continue;
      }
      emulator_->render(step_, static_cast<std::size_t>(most), volts.data());
      if (sink_) {
        sink_(step_, volts.data(), static_cast<std::size_t>(most));
      }
      step_ += most;
    }
  }

  bool may_go_on(emulation::TrueTime& time) const {
    if (pace_ == HeadPace::kAsFed) {
      const auto seen = emulator_->observe();
      if (seen.state == gs::head::State::kPlaying) {
        // Real time goes on from here when it no longer plays.
        time.start =
            std::chrono::steady_clock::now() -
            std::chrono::microseconds((step_ + kAtOnce) * 1000000 / emulation::TrueTime::kRate_hz);
        return seen.buffered > kReserve;
      }
    }
    return time.now() >= step_ + kAtOnce;
  }

  std::unique_ptr<emulation::HeadEmulator> emulator_;
  HeadPace pace_;
  Sink sink_;
  std::atomic<std::int64_t> step_{0};
  std::atomic<std::int64_t> limit_{kNever};
  std::atomic<bool> waiting_{false};
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last: it uses the others
};

inline head::HeadOptions options_for(const emulation::HeadEmulator& emulator) {
  head::HeadOptions options;
  options.port = emulator.port();
  return options;
}

}  // namespace gsbench::test
