#include "tcp_line.hpp"

#include "address.hpp"
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

namespace gs::host {
namespace {

using Found = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

// The addresses of a host, at least one; null: none, with the reason in `why`.
Found look_up(const std::string& text, int flags, std::string& why) {
  Found found(nullptr, freeaddrinfo);
  Address address;
  if (!read_address(text, address) || (!address.scheme.empty() && address.scheme != "tcp")) {
    why = "\"" + text + "\" is not ADDRESS:PORT, for instance 127.0.0.1:5000 or [::1]:5000";
    return found;
  }
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = flags;
  addrinfo* first = nullptr;
  if (const int error = getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(),
                                    &wanted, &first)) {
    why = text + ": cannot be found: " + gai_strerror(error);
    return found;
  }
  found.reset(first);
  return found;
}

std::string name_of(const sockaddr* address, socklen_t size) {
  char host[NI_MAXHOST] = "";
  char port[NI_MAXSERV] = "";
  getnameinfo(address, size, host, sizeof host, port, sizeof port, NI_NUMERICHOST | NI_NUMERICSERV);
  return text_of(host, port);
}

bool send_at_once(int socket) {
  const int yes = 1;
  return fcntl(socket, F_SETFL, O_NONBLOCK) == 0 &&
         setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes) == 0;
}

int failed(int socket, const std::string& address, std::string& why) {
  why = address + ": " + std::strerror(errno);
  if (socket >= 0) {
    ::close(socket);
  }
  return -1;
}

int listener_at(const addrinfo& at, std::string& why) {
  const int yes = 1;
  const int socket =
      ::socket(at.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, at.ai_protocol);
  // "localhost" has an address of each family: the one of IPv6 does not take the other's place.
  const bool is_set = socket >= 0 &&
                      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
                      (at.ai_family != AF_INET6 ||
                       setsockopt(socket, IPPROTO_IPV6, IPV6_V6ONLY, &yes, sizeof yes) == 0);
  if (!is_set || bind(socket, at.ai_addr, at.ai_addrlen) != 0 || ::listen(socket, 1) != 0) {
    return failed(socket, name_of(at.ai_addr, at.ai_addrlen), why);
  }
  return socket;
}

}  // namespace

// Each address of a name has 5 s to answer.
TcpLine::Outcome TcpLine::connect_to(const std::string& address) {
  const timeval longest{5, 0};
  Outcome outcome;
  const Found found = look_up(address, 0, outcome.why);
  for (const addrinfo* to = found.get(); to != nullptr; to = to->ai_next) {
    const int socket = ::socket(to->ai_family, SOCK_STREAM | SOCK_CLOEXEC, to->ai_protocol);
    if (socket >= 0 && setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest) == 0 &&
        ::connect(socket, to->ai_addr, to->ai_addrlen) == 0 && send_at_once(socket)) {
      outcome.descriptor = socket;
      return outcome;
    }
    errno = errno == EINPROGRESS ? ETIMEDOUT : errno;
    failed(socket, address, outcome.why);
  }
  return outcome;
}

int TcpLine::connect(std::string& far_end, std::string& why) {
  far_end = address_;
  if (!attempt_.running()) {
    attempt_.start([address = address_] { return connect_to(address); });
  }
  if (!was_connected_) {
    attempt_.wait();
  }
  const std::optional<Outcome> outcome = attempt_.take();
  if (!outcome) {
    return -1;
  }
  why = outcome->why;
  was_connected_ = was_connected_ || outcome->descriptor >= 0;
  return outcome->descriptor;
}

ListeningLine::~ListeningLine() {
  for (const int listener : listeners_) {
    ::close(listener);
  }
}

bool ListeningLine::listen(std::string& why) {
  const Found found = look_up(address_, AI_PASSIVE, why);
  for (const addrinfo* at = found.get(); at != nullptr; at = at->ai_next) {
    const int listener = listener_at(*at, why);
    if (listener >= 0) {
      listeners_.push_back(listener);
      report("listens at " + name_of(at->ai_addr, at->ai_addrlen));
    }
  }
  return !listeners_.empty();
}

int ListeningLine::connect(std::string& far_end, std::string& why) {
  for (const int listener : listeners_) {
    sockaddr_storage centre{};
    auto* const address = reinterpret_cast<sockaddr*>(&centre);
    socklen_t size = sizeof centre;
    const int socket = ::accept4(listener, address, &size, SOCK_CLOEXEC);
    if (socket >= 0 && send_at_once(socket)) {
      far_end = "the centre at " + name_of(address, size);
      return socket;
    }
    failed(socket, address_, why);
  }
  return -1;
}

}  // namespace gs::host
