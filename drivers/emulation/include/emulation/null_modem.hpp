// An emulated serial cable: two TCP ports of 127.0.0.1, one for the bench and one for the outlet,
// with one connection each. A thread of its own passes bytes both ways, unchanged unless a test
// sets a spoiler. Bytes sent while the other end is not connected are lost, as on a cable.
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

// Gets the bytes of one read and may change, remove or add bytes. Called from the cable's thread.
using Spoiler = std::function<void(std::vector<std::uint8_t>& bytes)>;

enum class Way : std::uint8_t { kToBench, kToOutlet };

class NullModem {
 public:
  static drivers::Result<std::unique_ptr<NullModem>> create();
  ~NullModem() { unplug(); }
  NullModem(const NullModem&) = delete;
  NullModem& operator=(const NullModem&) = delete;

  // The bench's port name for transport/transport.hpp, such as "tcp://127.0.0.1:40001".
  std::string bench_end() const {
    return "tcp://127.0.0.1:" + std::to_string(bench_.port.number());
  }
  std::uint16_t outlet_end() const { return outlet_.port.number(); }  // on 127.0.0.1

  // For fault injection. unplug() closes both connections; after plug_in(), both ends accept again.
  void unplug();
  [[nodiscard]] drivers::Status plug_in();

  // Sets the spoiler of one way. With an empty spoiler, bytes pass unchanged.
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
  std::array<Spoiler, 2> spoilers_;  // indexed by Way
  std::thread pump_;
};

}  // namespace gsbench::emulation
