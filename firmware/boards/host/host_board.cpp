#include "host_board.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gs::host {

HostBoard::~HostBoard() {
  if (doorbell_ >= 0) {
    ::close(doorbell_);
  }
}

bool HostBoard::start(const std::string& doorbell, std::string& why) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (doorbell.size() >= sizeof address.sun_path) {
    why = doorbell + ": too long for a socket";
    return false;
  }
  std::memcpy(address.sun_path, doorbell.c_str(), doorbell.size() + 1);
  doorbell_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (doorbell_ < 0 ||
      connect(doorbell_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    why = doorbell + ": " + std::strerror(errno);
    return false;
  }
  port_.start();
  return true;
}

void HostBoard::start_alone() {
  port_.start();
}

bool HostBoard::wait() {
  const auto line_events = static_cast<short>(line_.wants_to_write() ? POLLIN | POLLOUT : POLLIN);
  pollfd waited[] = {{doorbell_, POLLIN, 0}, {line_.descriptor(), line_events, 0}};
  const int longest_wait_ms = doorbell_ >= 0 ? 100 : 4;
  ::poll(waited, 2, longest_wait_ms);
  if (waited[0].revents != 0) {
    char rings[256];
    if (::recv(doorbell_, rings, sizeof rings, MSG_DONTWAIT) == 0) {
      return false;
    }
  }
  line_.serve();
  return true;
}

shared_memory_io::SharedMemory* map_terminals(const std::string& path, std::string& why) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) {
    why = path + ": " + std::strerror(errno);
    return nullptr;
  }
  const off_t size = lseek(file, 0, SEEK_END);
  void* mapped = size >= static_cast<off_t>(sizeof(shared_memory_io::SharedMemory))
                     ? mmap(nullptr, sizeof(shared_memory_io::SharedMemory), PROT_READ | PROT_WRITE,
                            MAP_SHARED, file, 0)
                     : MAP_FAILED;
  ::close(file);
  auto* terminals =
      mapped == MAP_FAILED ? nullptr : static_cast<shared_memory_io::SharedMemory*>(mapped);
  if (terminals == nullptr || terminals->magic != shared_memory_io::kMagic) {
    why = path + ": not a terminals file";
    return nullptr;
  }
  return terminals;
}

}  // namespace gs::host
