// A pseudo-terminal in the place of a serial port. What a test writes to the master comes from the
// port's far end.
#pragma once

#include <string>

#include <drivers/descriptor.hpp>

namespace gsbench::test {

class Pty {
 public:
  // At that path for as long as it lives, as udev names ports: the same however often it is
  // unplugged. Throws std::runtime_error.
  explicit Pty(std::string path);
  ~Pty();
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  int master() const { return master_.get(); }  // does not block

 private:
  std::string path_;
  drivers::Descriptor master_;
  // A terminal that nobody has open loses what is written to it, and reads as unplugged.
  drivers::Descriptor slave_;
};

}  // namespace gsbench::test
