// A serial cable without hardware: two TCP ports of 127.0.0.1, one for the bench and one for the
// outlet, each for one connection at a time. Bytes pass both ways as they are, unless a test spoils
// them. What is sent while nobody is at the other end is lost, as on a cable.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/listening.hpp>

namespace gsbench::emulation {

// What passes the cable in one go; may change, take away or add bytes.
using Spoiler = std::function<void(std::vector<std::uint8_t>& bytes)>;

enum class Way : std::uint8_t { kToBench, kToOutlet };

class NullModem {
 public:
  static drivers::Result<std::unique_ptr<NullModem>> create();
  ~NullModem() { unplug(); }
  NullModem(const NullModem&) = delete;
  NullModem& operator=(const NullModem&) = delete;

  // "tcp://127.0.0.1:40001", a transport's port
  std::string bench_end() const {
    return "tcp://127.0.0.1:" + std::to_string(bench_.port.number());
  }
  std::uint16_t outlet_end() const { return outlet_.port.number(); }  // 40002, on 127.0.0.1

  // For faults on purpose. Both ends hang up, and can be connected to again once the cable is
  // plugged in again.
  void unplug();
  [[nodiscard]] drivers::Status plug_in();

  // Empty: as it is.
  void spoil(Spoiler spoiler, Way way = Way::kToBench);

 private:
  struct End {
    LoopbackPort port;
    Descriptor connection;
  };

  NullModem(LoopbackPort bench, LoopbackPort outlet)
      : bench_{std::move(bench), {}}, outlet_{std::move(outlet), {}} {}
  void run();
  void pass(End& from, End& to, Way way);

  End bench_;
  End outlet_;
  Descriptor wake_;
  std::mutex mutex_;
  std::array<Spoiler, 2> spoilers_;  // by the way
  std::thread pump_;
};

}  // namespace gsbench::emulation
