// File descriptors that close themselves.
#pragma once

#include <string>

#include <drivers/result.hpp>

namespace gsbench::emulation {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(Descriptor&& other) noexcept : descriptor_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }

  int get() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }
  void close() noexcept;

 private:
  int release() noexcept;

  int descriptor_ = -1;
};

// A Unix socket of our own at a path, which must not be there yet.
drivers::Result<Descriptor> listen_on(const std::string& path);

}  // namespace gsbench::emulation
