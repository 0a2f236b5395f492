// A file descriptor that closes itself.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace gsbench::drivers {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(Descriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Descriptor& operator=(Descriptor other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Descriptor() { close(); }

  int get() const { return descriptor_; }  // -1: none
  bool is_open() const { return descriptor_ >= 0; }
  void close() noexcept {
    if (descriptor_ >= 0) {
      ::close(std::exchange(descriptor_, -1));
    }
  }

 private:
  int descriptor_ = -1;
};

// Blocks until poll() reports an event, timeout_ms at most. Returns the events, or 0 after a
// timeout or an error of poll(). An interruption by a signal restarts the wait.
inline short wait_for(int descriptor, short events, int timeout_ms) {
  pollfd one{descriptor, events, 0};
  int ready = 0;
  do {
    ready = ::poll(&one, 1, timeout_ms);
  } while (ready < 0 && errno == EINTR);
  return ready > 0 ? one.revents : short{0};
}

}  // namespace gsbench::drivers
