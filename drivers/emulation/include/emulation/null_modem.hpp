// A serial cable without hardware: a terminal device (a pseudo-terminal's slave, with a path under
// /dev/pts) at the bench's end, and at the outlet's end another, or a Unix socket that an
// emulator's serial port connects to. Bytes pass both ways as they are, unless a test spoils them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::emulation {

// What passes the cable in one go; may change, take away or add bytes.
using Spoiler = std::function<void(std::vector<std::uint8_t>& bytes)>;

enum class Way : std::uint8_t { kToBench, kToOutlet };

class NullModem {
 public:
  // Two terminal devices.
  static drivers::Result<NullModem> between_terminals();
  // A terminal device and a Unix socket that it listens on, for one that connects at a time.
  static drivers::Result<NullModem> to_socket(const std::string& socket_path);

  NullModem(NullModem&&) noexcept;
  NullModem& operator=(NullModem&&) noexcept;
  ~NullModem();  // both ends are unplugged

  const std::string& bench_end() const;   // "/dev/pts/3"
  const std::string& outlet_end() const;  // another, or the socket

  // Empty: as it is.
  void spoil(Spoiler spoiler, Way way = Way::kToBench);

 private:
  struct Impl;
  explicit NullModem(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::emulation
