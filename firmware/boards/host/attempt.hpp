// A call that may block, such as a connection or the lookup of a name, in a thread of its own.
#pragma once

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <future>
#include <optional>
#include <thread>
#include <utility>

namespace gs::host {

template <class Result>
class Attempt {
 public:
  Attempt() = default;
  // Blocks until the call has returned.
  ~Attempt() { finish(); }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  // Until take() returns its result, what the call uses belongs to its thread.
  void start(std::function<Result()> call) {
    // Without SA_RESTART: interrupt() ends a call of the system.
    struct sigaction ignore {};
    ignore.sa_handler = [](int) {};
    sigaction(kInterrupt, &ignore, nullptr);
    call_ = std::packaged_task<Result()>(std::move(call));
    result_ = call_.get_future();
    thread_ = std::thread([this] { call_(); });
  }
  bool running() const { return result_.valid(); }

  // Returns the result once, after the call has returned.
  std::optional<Result> take() {
    if (!running() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    thread_.join();
    return result_.get();
  }

  // Lets the system's call in which the thread waits now fail with EINTR. A lookup goes on.
  void interrupt() {
    if (thread_.joinable()) {
      pthread_kill(thread_.native_handle(), kInterrupt);
    }
  }
  // Interrupts the call, again and again, until it returns.
  void finish() {
    while (running() && !take()) {
      interrupt();
      result_.wait_for(std::chrono::milliseconds(20));
    }
  }
  // Blocks until the call has returned.
  void wait() const { result_.wait(); }

 private:
  static constexpr int kInterrupt = SIGUSR1;

  std::packaged_task<Result()> call_;
  std::future<Result> result_;
  std::thread thread_;
};

}  // namespace gs::host
