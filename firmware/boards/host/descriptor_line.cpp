#include "descriptor_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include <wire/frame.hpp>

namespace gs::host {

bool DescriptorLine::open(std::string& why) {
  constexpr auto kBetweenConnections = std::chrono::milliseconds(250);
  close();
  next_attempt_ = std::chrono::steady_clock::now() + kBetweenConnections;
  std::string far_end;
  descriptor_ = connect(far_end, why);
  if (descriptor_ < 0) {
    return false;
  }
  report((far_end == far_end_ ? "connected again to " : "connected to ") + far_end);
  far_end_ = far_end;
  return true;
}

void DescriptorLine::close() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    descriptor_ = -1;
    report("no longer connected to " + far_end_);
  }
  partial_.clear();  // its end was lost with the connection
  // Each frame begins and ends with a zero; of the first one, some bytes may have been sent.
  const auto zeros = std::count(to_send_.begin(), to_send_.end(), std::uint8_t{0});
  unsent_ += static_cast<std::uint32_t>((zeros + 1) / 2);
  to_send_.clear();
}

bool DescriptorLine::send(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t kMostWaitingBytes = 8192;
  if (descriptor_ < 0 || to_send_.size() + count > kMostWaitingBytes) {
    return false;
  }
  to_send_.insert(to_send_.end(), bytes, bytes + count);
  transmit();
  return true;
}

void DescriptorLine::serve() {
  if (descriptor_ < 0) {
    std::string why;
    const bool is_due = is_connecting() || std::chrono::steady_clock::now() >= next_attempt_;
    if (!is_due || !open(why)) {
      return;
    }
  }
  receive();
  transmit();
}

// What the outlet has not handled yet is not read further: TCP then holds the sender back.
void DescriptorLine::receive() {
  std::uint8_t bytes[1024];
  while (descriptor_ >= 0 && received_.size() < kMostReceivedBytes) {
    const ssize_t got = ::read(descriptor_, bytes, sizeof bytes);
    if (got > 0) {
      take(bytes, static_cast<std::size_t>(got));
      continue;
    }
    // 0: the other side closed the connection. EAGAIN: no bytes are available.
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      close();
    }
    return;
  }
}

// Only whole frames are handed on, so that half of one is not reported to the centre that connects
// next.
void DescriptorLine::take(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    partial_.push_back(bytes[i]);
    if (bytes[i] == 0 || partial_.size() > wire::kLongestFrame) {
      received_.insert(received_.end(), partial_.begin(), partial_.end());
      partial_.clear();
    }
  }
}

void DescriptorLine::transmit() {
  while (descriptor_ >= 0 && !to_send_.empty()) {
    const ssize_t put = ::write(descriptor_, to_send_.data(), to_send_.size());
    if (put <= 0) {
      if (put < 0 && errno != EAGAIN && errno != EINTR) {
        close();
      }
      return;
    }
    to_send_.erase(to_send_.begin(), to_send_.begin() + put);
  }
}

}  // namespace gs::host
