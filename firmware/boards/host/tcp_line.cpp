#include "tcp_line.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace gs::host {
namespace {

bool parse(const std::string& address, sockaddr_in& to, std::string& why) {
  to = {};
  to.sin_family = AF_INET;
  const std::size_t colon = address.find(':');
  std::uint16_t port = 0;
  const char* const end = address.data() + address.size();
  const char* const digits = colon == std::string::npos ? end : address.data() + colon + 1;
  const auto read = std::from_chars(digits, end, port);
  if (read.ec != std::errc() || read.ptr != end || port == 0 ||
      inet_pton(AF_INET, address.substr(0, colon).c_str(), &to.sin_addr) != 1) {
    why = "\"" + address + "\" is not ADDRESS:PORT, for instance 127.0.0.1:5000";
    return false;
  }
  to.sin_port = htons(port);
  return true;
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

}  // namespace

int TcpLine::connect(std::string& why) {
  sockaddr_in to{};
  if (!parse(address_, to, why)) {
    return -1;
  }
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0 || ::connect(socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0 ||
      !send_at_once(socket)) {
    return failed(socket, address_, why);
  }
  return socket;
}

ListeningLine::~ListeningLine() {
  if (listener_ >= 0) {
    ::close(listener_);
  }
}

bool ListeningLine::listen(std::string& why) {
  sockaddr_in at{};
  if (!parse(address_, at, why)) {
    return false;
  }
  const int yes = 1;
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket < 0 || setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      bind(socket, reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 ||
      ::listen(socket, 1) != 0) {
    return failed(socket, address_, why) >= 0;
  }
  listener_ = socket;
  return true;
}

int ListeningLine::connect(std::string& why) {
  const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (socket < 0 || !send_at_once(socket)) {
    return failed(socket, address_, why);
  }
  return socket;
}

}  // namespace gs::host
