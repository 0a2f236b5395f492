// Stand-ins for serial adapters with modem lines, in virtual time: it advances only when a test
// advances it, and all readers sleep meanwhile.
#pragma once

#include <fcntl.h>
#include <relay_modem_line/modem_line_sense.hpp>
#include <sys/ioctl.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace gsbench::test {

using std::chrono::steady_clock;

class ModemLines {
 public:
  // Call it before the relay sense is destroyed.
  void end() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  relay::ModemLineSystem system() {
    return {[this](const std::string& port) { return open(port); },
            [this](int descriptor, unsigned long request, int* bits) {
              return ioctl(descriptor, request, bits);
            },
            [this] {
              const std::lock_guard<std::mutex> lock(mutex_);
              return now_;
            },
            [this](steady_clock::duration duration) { sleep(duration); }};
  }

  // Advances the time. Each reader that wakes up meanwhile has read before this returns.
  void advance(steady_clock::duration duration) {
    std::unique_lock<std::mutex> lock(mutex_);
    const steady_clock::time_point end = now_ + duration;
    while (now_ < end) {
      EXPECT_TRUE(changed_.wait_for(lock, std::chrono::minutes(1), [&] { return all_sleep(); }));
      now_ = end;
      for (const auto& [thread, wakes] : sleeping_) {
        now_ = std::min(now_, wakes);
      }
      changed_.notify_all();
    }
    EXPECT_TRUE(changed_.wait_for(lock, std::chrono::minutes(1), [&] { return all_sleep(); }));
  }
  // As if the machine had been busy: the next readings happen this much later.
  void stall(steady_clock::duration duration) {
    const std::lock_guard<std::mutex> lock(mutex_);
    now_ += duration;
    changed_.notify_all();
  }

  void set(const std::string& port, int bits) {
    const std::lock_guard<std::mutex> lock(mutex_);
    bits_[port] = bits;
  }
  void fail(const std::string& port, int error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    errors_[port] = error;
  }
  int outputs(const std::string& port) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return outputs_[port];
  }
  steady_clock::time_point now() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return now_;
  }

 private:
  drivers::Result<drivers::Descriptor> open(const std::string& port) {
    const std::lock_guard<std::mutex> lock(mutex_);
    drivers::Descriptor descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    ports_[descriptor.get()] = port;
    ++readers_;
    return descriptor;
  }

  int ioctl(int descriptor, unsigned long request, int* bits) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string& port = ports_.at(descriptor);
    if (errors_.count(port) > 0) {
      readers_ -= request == TIOCMGET ? 1 : 0;  // it reads no more
      changed_.notify_all();
      errno = errors_[port];
      return -1;
    }
    if (request == TIOCMBIS) {
      outputs_[port] |= *bits;
    } else {
      EXPECT_EQ(request, static_cast<unsigned long>(TIOCMGET));
      *bits = bits_[port];
    }
    return 0;
  }

  void sleep(steady_clock::duration duration) {
    std::unique_lock<std::mutex> lock(mutex_);
    const steady_clock::time_point wakes = now_ + duration;
    sleeping_[std::this_thread::get_id()] = wakes;
    changed_.notify_all();
    changed_.wait(lock, [&] { return ended_ || now_ >= wakes; });
    sleeping_.erase(std::this_thread::get_id());
  }

  // Nobody who sleeps should be awake.
  bool all_sleep() const {
    if (sleeping_.size() < readers_) {
      return false;
    }
    for (const auto& [thread, wakes] : sleeping_) {
      if (wakes <= now_) {
        return false;
      }
    }
    return true;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  steady_clock::time_point now_{std::chrono::hours(1000)};
  bool ended_ = false;
  std::size_t readers_ = 0;
  std::map<std::thread::id, steady_clock::time_point> sleeping_;
  std::map<int, std::string> ports_;
  std::map<std::string, int> bits_;
  std::map<std::string, int> errors_;
  std::map<std::string, int> outputs_;
};

}  // namespace gsbench::test
