#include "tcp_line.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace gs::host {

bool TcpLine::open(std::string& why) {
  constexpr auto kBetweenConnections = std::chrono::milliseconds(250);
  close();
  next_attempt_ = std::chrono::steady_clock::now() + kBetweenConnections;
  sockaddr_in to{};
  to.sin_family = AF_INET;
  const std::size_t colon = address_.find(':');
  const unsigned long port =
      colon == std::string::npos ? 0 : std::strtoul(address_.c_str() + colon + 1, nullptr, 10);
  if (port == 0 || port > 65535 ||
      inet_pton(AF_INET, address_.substr(0, colon).c_str(), &to.sin_addr) != 1) {
    why = "\"" + address_ + "\" is not ADDRESS:PORT, for instance 127.0.0.1:5000";
    return false;
  }
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  descriptor_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  if (descriptor_ < 0 ||
      ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0 ||
      fcntl(descriptor_, F_SETFL, O_NONBLOCK) != 0 ||
      setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes) != 0) {
    why = address_ + ": " + std::strerror(errno);
    close();
    return false;
  }
  return true;
}

void TcpLine::close() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    descriptor_ = -1;
  }
  to_send_.clear();
}

bool TcpLine::send(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t kMostWaitingBytes = 8192;
  if (descriptor_ < 0 || to_send_.size() + count > kMostWaitingBytes) {
    return false;
  }
  to_send_.insert(to_send_.end(), bytes, bytes + count);
  transmit();
  return true;
}

void TcpLine::serve() {
  if (descriptor_ < 0) {
    std::string why;
    if (std::chrono::steady_clock::now() < next_attempt_ || !open(why)) {
      return;
    }
  }
  receive();
  transmit();
}

void TcpLine::receive() {
  std::uint8_t bytes[1024];
  while (descriptor_ >= 0) {
    const ssize_t got = ::recv(descriptor_, bytes, sizeof bytes, 0);
    if (got > 0) {
      received_.insert(received_.end(), bytes, bytes + got);
      continue;
    }
    // 0: the other side closed the connection. EAGAIN: no bytes are available.
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      close();
    }
    return;
  }
}

void TcpLine::transmit() {
  while (descriptor_ >= 0 && !to_send_.empty()) {
    const ssize_t put = ::send(descriptor_, to_send_.data(), to_send_.size(), MSG_NOSIGNAL);
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
