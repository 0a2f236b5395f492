// A pseudo-terminal as a serial port. Bytes that a test writes to the master arrive at the port.
#pragma once

#include <string>

#include <drivers/descriptor.hpp>

namespace gsbench::test {

class Pty {
 public:
  // Creates a symbolic link at `path` for its lifetime, as udev does for a port. Throws
  // std::runtime_error.
  explicit Pty(std::string path);
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  int master() const { return master_.get(); }  // does not block

 private:
  std::string path_;
  drivers::Descriptor master_;
  // Keeps the terminal open: otherwise it loses bytes written to it, and reads as unplugged.
  drivers::Descriptor slave_;
};

}  // namespace gsbench::test
