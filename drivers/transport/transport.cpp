#include "kinds.hpp"
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <drivers/descriptor.hpp>
#include <transport/transport.hpp>

namespace gsbench::transport {

using drivers::Done;
using drivers::Error;
using drivers::Status;

Status Transport::send(const std::vector<std::uint8_t>& bytes, std::chrono::milliseconds patience) {
  if (!is_open()) {
    return failure("cannot be sent to", "not open");
  }
  for (std::size_t sent = 0; sent < bytes.size();) {
    const auto taken = write_some(bytes.data() + sent, bytes.size() - sent);
    if (!taken.ok()) {
      return Error{taken.error()};
    }
    sent += taken.value();
    if (sent < bytes.size() &&
        !drivers::wait_for(descriptor(), POLLOUT, static_cast<int>(patience.count()))) {
      return failure("cannot be sent to", "accepts no data");
    }
  }
  return Done{};
}

Status Transport::receive(std::vector<std::uint8_t>& bytes, Clock::time_point until) {
  if (!is_open()) {
    return failure("cannot be read", "not open");
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
  const short ready = drivers::wait_for(descriptor(), POLLIN,
                                        left.count() > 0 ? static_cast<int>(left.count()) : 0);
  if (ready == 0) {
    return Done{};
  }
  const std::size_t before = bytes.size();
  Status read = read_some(bytes);
  // Ready without bytes is a hang-up, which libserialport reports as silence.
  if (read.ok() && bytes.size() == before && (ready & (POLLHUP | POLLERR)) != 0) {
    return failure("cannot be read", "the far end has hung up");
  }
  return read;
}

std::unique_ptr<Transport> make_transport(const std::string& port, int baud) {
  return is_tcp(port) ? make_tcp(port) : make_serial(port, baud);
}

Status check_form(const std::string& port) {
  if (is_tcp(port)) {
    return check_address(port);
  }
  if (port.size() < 2 || port.front() != '/' || port.back() == '/') {
    return Error{(port.empty() ? "an empty text" : port + ':') +
                 " is neither of the form tcp://host:port nor the path of a device"};
  }
  return Done{};
}

Status check_port(const std::string& port) {
  if (is_tcp(port)) {
    return check_address(port);
  }
  if (access(port.c_str(), R_OK | W_OK) != 0) {
    return Error{port + ": " + std::strerror(errno)};
  }
  return Done{};
}

}  // namespace gsbench::transport
