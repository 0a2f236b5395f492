// A serial cable without hardware: two TCP ports of 127.0.0.1, one for the bench and one for the
// outlet, each for one connection at a time. Bytes pass both ways as they are, unless a test spoils
// them. What is sent while nobody is at the other end is lost, as on a cable.
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
  static drivers::Result<NullModem> create();

  NullModem(NullModem&&) noexcept;
  NullModem& operator=(NullModem&&) noexcept;
  ~NullModem();  // unplug()

  std::string bench_end() const;     // "tcp://127.0.0.1:40001", a transport's port
  std::uint16_t outlet_end() const;  // 40002, on 127.0.0.1

  // For faults on purpose. Both ends hang up, and can be connected to again once the cable is
  // plugged in again.
  void unplug();
  [[nodiscard]] drivers::Status plug_in();

  // Empty: as it is.
  void spoil(Spoiler spoiler, Way way = Way::kToBench);

 private:
  struct Impl;
  explicit NullModem(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::emulation
