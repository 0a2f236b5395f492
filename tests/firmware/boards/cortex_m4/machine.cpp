#include "machine.hpp"

#include <netinet/in.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace gs::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error("path too long: " + path);
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return address;
}

int unix_socket() {
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) fail("socket");
  return descriptor;
}

bool readable(int descriptor, std::chrono::milliseconds patience) {
  pollfd waiting = {descriptor, POLLIN, 0};
  return ::poll(&waiting, 1, static_cast<int>(patience.count())) > 0;
}

}  // namespace

Socket& Socket::operator=(Socket&& other) noexcept {
  close();
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

void Socket::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

Socket Socket::listen(const std::string& path) {
  Socket socket(unix_socket());
  const sockaddr_un address = address_of(path);
  ::unlink(path.c_str());
  if (::bind(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
          0 ||
      ::listen(socket.descriptor_, 1) != 0) {
    fail(path);
  }
  return socket;
}

Socket Socket::listen_on_loopback(std::string& address) {
  Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof at;
  auto* const generic = reinterpret_cast<sockaddr*>(&at);
  if (::bind(socket.descriptor_, generic, size) != 0 || ::listen(socket.descriptor_, 1) != 0 ||
      ::getsockname(socket.descriptor_, generic, &size) != 0) {
    fail("127.0.0.1");
  }
  address = "127.0.0.1:" + std::to_string(ntohs(at.sin_port));
  return socket;
}

Socket Socket::accept(std::chrono::milliseconds patience) const {
  if (!readable(descriptor_, patience)) throw std::runtime_error("qemu does not connect");
  const int connected = ::accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC);
  if (connected < 0) fail("accept");
  return Socket(connected);
}

Socket Socket::connect(const std::string& path) {
  Socket socket(unix_socket());
  const sockaddr_un address = address_of(path);
  if (::connect(socket.descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) !=
      0) {
    fail(path);
  }
  return socket;
}

void Socket::send(const void* bytes, std::size_t count) const {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(descriptor_, at, count, MSG_NOSIGNAL);
    if (sent < 0) fail("send to qemu");
    at += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

std::string Socket::receive(std::size_t most, std::chrono::milliseconds patience) const {
  if (!readable(descriptor_, patience)) return {};
  std::string bytes(most, '\0');
  const ssize_t count = ::recv(descriptor_, bytes.data(), most, 0);
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

Machine::Machine(const std::string& folder, std::vector<std::string> arguments,
                 std::size_t serial_ports)
    : debugger_(folder + "/debugger") {
  arguments.insert(arguments.begin(), "qemu-system-arm");
  for (const char* more : {"-display", "none", "-monitor", "none", "-nic", "none"}) {
    arguments.emplace_back(more);
  }
  std::vector<Socket> listening;
  for (std::size_t port = 0; port < serial_ports; ++port) {
    std::string name = "serial";
    name += std::to_string(port);
    std::string path = folder;
    path.append("/").append(name);
    std::string socket = "socket,id=";
    socket.append(name).append(",path=").append(path);
    listening.push_back(Socket::listen(path));
    arguments.insert(arguments.end(), {"-chardev", socket, "-serial", "chardev:" + name});
  }
  ::unlink(debugger_.c_str());
  arguments.insert(arguments.end(),
                   {"-chardev", "socket,id=debugger,server=on,wait=off,path=" + debugger_, "-gdb",
                    "chardev:debugger"});
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) fail("fork");
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() == parent) ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  try {
    for (const Socket& socket : listening) serial_.push_back(socket.accept(kPatience));
  } catch (...) {
    kill();
    throw;
  }
}

void Machine::kill() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

}  // namespace gs::test
