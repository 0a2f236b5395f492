// Listening sockets for emulated outlets and for the bench.
#pragma once

#include <cstdint>
#include <string>

#include <drivers/descriptor.hpp>
#include <drivers/result.hpp>

namespace gsbench::emulation {

using drivers::Descriptor;

// A listening Unix socket at `path`. An error if the path exists.
drivers::Result<Descriptor> listen_on(const std::string& path);

// A TCP port of 127.0.0.1, reserved as long as this object lives, whether it listens or not.
class LoopbackPort {
 public:
  static drivers::Result<LoopbackPort> reserve();

  std::uint16_t number() const { return number_; }
  [[nodiscard]] drivers::Status listen();
  // Stops listening; connections are refused.
  void refuse() { listening_.close(); }
  // The listening socket; -1: not listening.
  int descriptor() const { return listening_.get(); }
  // Returns the next waiting connection, set to non-blocking and TCP_NODELAY. If none is waiting,
  // the returned descriptor is closed. Does not block.
  Descriptor accept() const;

 private:
  LoopbackPort() = default;

  std::uint16_t number_ = 0;
  Descriptor reservation_;
  Descriptor listening_;
};

}  // namespace gsbench::emulation
