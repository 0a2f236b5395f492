#include "send_at_once.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cstdlib>
#include <filesystem>

namespace gsbench::link {
namespace {

// 0: not a TCP connection.
unsigned peer_port(int descriptor) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &size) != 0) {
    return 0;
  }
  switch (peer.ss_family) {
    case AF_INET:
      return ntohs(reinterpret_cast<const sockaddr_in&>(peer).sin_port);
    case AF_INET6:
      return ntohs(reinterpret_cast<const sockaddr_in6&>(peer).sin6_port);
    default:
      return 0;
  }
}

}  // namespace

void send_at_once(const std::string& url) {
  const auto port =
      static_cast<unsigned>(std::strtoul(url.c_str() + url.rfind(':') + 1, nullptr, 10));
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    const int descriptor =
        static_cast<int>(std::strtol(entry.path().filename().c_str(), nullptr, 10));
    if (port != 0 && peer_port(descriptor) == port) {
      const int yes = 1;
      setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    }
  }
}

}  // namespace gsbench::link
