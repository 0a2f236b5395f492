// A qemu process, its serial ports on unix sockets that the test listens on, and its debugger's
// port. Killed by its process id at the end of its scope, and by the kernel should the test die.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace gs::test {

// Nothing here takes longer: what does hangs, and the test says so.
constexpr std::chrono::seconds kPatience{30};

class Socket {
 public:
  Socket() = default;
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  ~Socket() { close(); }
  Socket(Socket&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  Socket& operator=(Socket&& other) noexcept;

  static Socket listen(const std::string& path);
  // On a free port of 127.0.0.1; `address`: "127.0.0.1:40001".
  static Socket listen_on_loopback(std::string& address);
  Socket accept(std::chrono::milliseconds patience) const;
  static Socket connect(const std::string& path);

  void send(const void* bytes, std::size_t count) const;
  // What is there, at most `most` bytes; empty after `patience`, and where the far end is gone.
  std::string receive(std::size_t most, std::chrono::milliseconds patience) const;
  void close();

 private:
  int descriptor_ = -1;
};

class Machine {
 public:
  // `folder` is for its sockets. One per serial port is made and connected, in their order.
  Machine(const std::string& folder, std::vector<std::string> arguments, std::size_t serial_ports);
  ~Machine() { kill(); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const Socket& serial(std::size_t port) const { return serial_.at(port); }
  const std::string& debugger() const { return debugger_; }
  // As a loss of power: no signal handler runs.
  void kill();

 private:
  pid_t pid_ = -1;
  std::vector<Socket> serial_;
  std::string debugger_;
};

}  // namespace gs::test
