#include "descriptor.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    close();
    descriptor_ = other.release();
  }
  return *this;
}

void Descriptor::close() noexcept {
  if (descriptor_ >= 0) {
    ::close(release());
  }
}

int Descriptor::release() noexcept {
  return std::exchange(descriptor_, -1);
}

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
      listen(listening.get(), 1) != 0) {
    return Error{path + ": " + std::strerror(errno)};
  }
  return listening;
}

}  // namespace gsbench::emulation
