// Ends the calls of a source early, for the drivers of sources.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

#include <drivers/result.hpp>

namespace gsbench::source {

class Interrupt {
 public:
  using Clock = std::chrono::steady_clock;

  // A driver asks before each command, and while it waits: see part_of(). If true, it ends the call
  // with error().
  bool is_set() {
    noticed_ = noticed_ || (!ignored_ && flag_ != nullptr && flag_->load());
    return noticed_ && !ignored_;
  }
  static drivers::Error error() { return {"interrupted"}; }
  // Blocks until `time`. An error if interrupted before.
  drivers::Status wait_until(Clock::time_point time);
  // A wait until `until` is divided into parts; the first one ends then.
  static Clock::time_point part_of(Clock::time_point until) {
    return std::min(until, Clock::now() + std::chrono::milliseconds(20));
  }

  // While one exists, is_set() is false.
  class Ignored {
   public:
    explicit Ignored(Interrupt& interrupt) : interrupt_(interrupt), before_(interrupt.ignored_) {
      interrupt_.ignored_ = true;
    }
    ~Ignored() { interrupt_.ignored_ = before_; }
    Ignored(const Ignored&) = delete;
    Ignored& operator=(const Ignored&) = delete;

   private:
    Interrupt& interrupt_;
    bool before_;
  };

  // ---- For the base class of sources.

  void heed(const std::atomic<bool>* flag) { flag_ = flag; }
  void begin_call() { noticed_ = false; }
  bool noticed() const { return noticed_; }  // in this call

 private:
  const std::atomic<bool>* flag_ = nullptr;
  bool noticed_ = false;
  bool ignored_ = false;
};

}  // namespace gsbench::source
