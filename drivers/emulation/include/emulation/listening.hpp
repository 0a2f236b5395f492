// Sockets that wait for an emulated outlet, or for the bench, to connect.
#pragma once

#include <cstdint>
#include <string>

#include <drivers/descriptor.hpp>
#include <drivers/result.hpp>

namespace gsbench::emulation {

using drivers::Descriptor;

// A Unix socket of our own at a path, which must not be there yet.
drivers::Result<Descriptor> listen_on(const std::string& path);

// A TCP port of 127.0.0.1 that nobody else gets for as long as this lives, listened to or not.
class LoopbackPort {
 public:
  static drivers::Result<LoopbackPort> reserve();

  std::uint16_t number() const { return number_; }
  [[nodiscard]] drivers::Status listen();
  // From now on, connections are refused.
  void refuse() { listening_.close(); }
  // Of the socket that waits for connections; -1: none are taken.
  int descriptor() const { return listening_.get(); }
  // The next connection, which neither blocks nor delays small messages; closed: none waits.
  Descriptor accept() const;

 private:
  LoopbackPort() = default;

  std::uint16_t number_ = 0;
  Descriptor reservation_;
  Descriptor listening_;
};

}  // namespace gsbench::emulation
