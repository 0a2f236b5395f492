#include "serial_line.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gs::host {
namespace {

constexpr std::size_t kMostWaiting = 8192;
constexpr auto kBetweenAttempts = std::chrono::milliseconds(250);

}  // namespace

bool SerialLine::open(std::string& why) {
  close();
  next_attempt_ = std::chrono::steady_clock::now() + kBetweenAttempts;
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios settings{};
  if (descriptor_ < 0 || tcgetattr(descriptor_, &settings) != 0) {
    why = path_ + ": " + std::strerror(errno);
    close();
    return false;
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL;
  cfsetspeed(&settings, B921600);
  tcsetattr(descriptor_, TCSANOW, &settings);
  tcflush(descriptor_, TCIFLUSH);
  return true;
}

void SerialLine::close() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    descriptor_ = -1;
  }
  to_send_.clear();
}

bool SerialLine::send(const std::uint8_t* bytes, std::size_t count) {
  if (descriptor_ < 0 || to_send_.size() + count > kMostWaiting) {
    return false;
  }
  to_send_.insert(to_send_.end(), bytes, bytes + count);
  transmit();
  return true;
}

bool SerialLine::take_byte(std::uint8_t& byte) {
  if (received_.empty()) {
    return false;
  }
  byte = received_.front();
  received_.pop_front();
  return true;
}

void SerialLine::serve() {
  if (descriptor_ < 0) {
    std::string why;
    if (std::chrono::steady_clock::now() < next_attempt_ || !open(why)) {
      return;
    }
  }
  receive();
  transmit();
}

void SerialLine::receive() {
  std::uint8_t bytes[1024];
  while (descriptor_ >= 0) {
    const ssize_t got = ::read(descriptor_, bytes, sizeof bytes);
    if (got > 0) {
      received_.insert(received_.end(), bytes, bytes + got);
      continue;
    }
    // 0 is a hang-up: a line that merely has nothing to say is EAGAIN.
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      close();
    }
    return;
  }
}

void SerialLine::transmit() {
  while (descriptor_ >= 0 && !to_send_.empty()) {
    std::uint8_t bytes[1024];
    std::size_t count = 0;
    for (; count < sizeof bytes && count < to_send_.size(); ++count) {
      bytes[count] = to_send_[count];
    }
    const ssize_t put = ::write(descriptor_, bytes, count);
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
