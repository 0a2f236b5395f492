#include "kinds.hpp"
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <memory>

#include <drivers/descriptor.hpp>
#include <transport/address.hpp>

namespace gsbench::transport {

using drivers::Descriptor;
using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr const char* kScheme = "tcp://";
constexpr int kConnect_ms = 500;
constexpr int kSendBuffer_bytes = 65536;

// The resolver takes an IPv6 address without the brackets that a URL puts around it.
std::string without_brackets(const std::string& host) {
  return host.size() > 2 && host.front() == '[' && host.back() == ']'
             ? host.substr(1, host.size() - 2)
             : host;
}

// Returns 0 or an errno value.
int connect_within(int socket, const addrinfo& to) {
  if (connect(socket, to.ai_addr, to.ai_addrlen) == 0) {
    return 0;
  }
  if (errno != EINPROGRESS) {
    return errno;
  }
  if (!drivers::wait_for(socket, POLLOUT, kConnect_ms)) {
    return ETIMEDOUT;
  }
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

bool is_tcp(const std::string& port) {
  std::string scheme = port.substr(0, std::strlen(kScheme));
  std::transform(scheme.begin(), scheme.end(), scheme.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return scheme == kScheme;
}

std::string in_one_form(const std::string& port) {
  const auto address = is_tcp(port) ? read_address(port) : std::nullopt;
  return address ? text_of(*address) : port;
}

Status check_address(const std::string& port) {
  if (read_address(port)) {
    return Done{};
  }
  return Error{port + ": is not of the form tcp://host:port, with a port from 1 to 65535"};
}

namespace {

class Tcp final : public Transport {
 public:
  using Transport::Transport;

  Status open() override {
    close();
    const auto address = read_address(port());
    if (!address) {
      return check_address(port());
    }
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int error = getaddrinfo(address->host.c_str(), std::to_string(address->port).c_str(),
                                      &wanted, &found)) {
      return failure("cannot be found", gai_strerror(error));
    }
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
    // A name may have IPv4 and IPv6 addresses while the host listens on one of them.
    int error = EHOSTUNREACH;
    for (const addrinfo* to = found; to != nullptr && error != 0; to = to->ai_next) {
      socket_ = Descriptor(
          ::socket(to->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, to->ai_protocol));
      error = socket_.is_open() ? connect_within(socket_.get(), *to) : errno;
    }
    if (error != 0) {
      close();
      return failure("cannot be connected to", std::strerror(error));
    }
    // Small messages leave at once, not when the one before has been acknowledged.
    const int yes = 1;
    setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    // A larger one would take megabytes at once and then nothing for seconds.
    setsockopt(socket_.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer_bytes, sizeof kSendBuffer_bytes);
    return Done{};
  }

  void close() noexcept override { socket_.close(); }
  int descriptor() const override { return socket_.get(); }

 private:
  Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) override {
    const ssize_t taken = ::send(socket_.get(), bytes, count, MSG_NOSIGNAL);
    if (taken >= 0) {
      return static_cast<std::size_t>(taken);
    }
    if (errno == EAGAIN || errno == EINTR) {
      return std::size_t{0};
    }
    return failure("cannot be sent to", std::strerror(errno));
  }

  Status read_some(std::vector<std::uint8_t>& bytes) override {
    std::uint8_t some[4096];
    const ssize_t got = ::recv(socket_.get(), some, sizeof some, 0);
    if (got > 0) {
      bytes.insert(bytes.end(), some, some + got);
      return Done{};
    }
    if (got == 0) {
      return failure("cannot be read", "the far end has hung up");
    }
    if (errno == EAGAIN || errno == EINTR) {
      return Done{};
    }
    return failure("cannot be read", std::strerror(errno));
  }

  Descriptor socket_;
};

}  // namespace

std::vector<std::string> addresses_of(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(without_brackets(host).c_str(), nullptr, &wanted, &found) != 0) {
    return {host};
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
  std::vector<std::string> addresses;
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    char text[NI_MAXHOST] = "";
    if (getnameinfo(one->ai_addr, one->ai_addrlen, text, sizeof text, nullptr, 0, NI_NUMERICHOST) ==
        0) {
      addresses.emplace_back(text);
    }
  }
  return addresses;
}

std::unique_ptr<Transport> make_tcp(const std::string& port) {
  return std::make_unique<Tcp>(port);
}

}  // namespace gsbench::transport
