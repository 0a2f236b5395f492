#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>

#include <emulation/listening.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr int kWaiting = 4;  // connections that may wait to be accepted

// Bound to 127.0.0.1 with SO_REUSEADDR, so that a reserving socket, which does not listen, can
// share the port. `port`: 0 for a free one; set to the port bound.
Result<Descriptor> bound_socket(std::uint16_t& port) {
  Descriptor made(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  socklen_t size = sizeof address;
  const int yes = 1;
  if (!made.is_open() || setsockopt(made.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      bind(made.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
      getsockname(made.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    return Error{"127.0.0.1:" + std::to_string(port) + ": " + std::strerror(errno)};
  }
  port = ntohs(address.sin_port);
  return made;
}

}  // namespace

Result<Descriptor> listen_on(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    return Error{path + ": too long for a socket"};
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  Descriptor listening(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!listening.is_open() ||
      bind(listening.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listening.get(), 1) != 0) {
    return Error{path + ": " + std::strerror(errno)};
  }
  return listening;
}

Result<LoopbackPort> LoopbackPort::reserve() {
  LoopbackPort port;
  const Status bound = bound_socket(port.number_).move_to(port.reservation_);
  return bound.ok() ? Result<LoopbackPort>(std::move(port)) : Error{bound.error()};
}

Status LoopbackPort::listen() {
  Status bound = bound_socket(number_).move_to(listening_);
  if (bound.ok() && ::listen(listening_.get(), kWaiting) != 0) {
    return Error{"127.0.0.1:" + std::to_string(number_) + ": " + std::strerror(errno)};
  }
  return bound;
}

Descriptor LoopbackPort::accept() const {
  Descriptor accepted(accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  const int yes = 1;
  setsockopt(accepted.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  return accepted;
}

}  // namespace gsbench::emulation
