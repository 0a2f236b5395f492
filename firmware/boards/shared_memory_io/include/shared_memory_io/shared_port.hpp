// The outlet's side of its terminals: samples in, the relay's coil out.
#pragma once

#include <shared_memory_io/shared_memory.hpp>

#include <cstddef>
#include <cstdint>

namespace gs::shared_memory_io {

class SharedPort {
 public:
  explicit SharedPort(SharedMemory& terminals) : terminals_(terminals) {}

  // An outlet that restarts counts from what is written from now on.
  void start();

  bool samples_wait() const { return terminals_.written != terminals_.taken; }
  // Up to `most` of the oldest samples that were not taken; `lost` came before them and is gone.
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost);

  bool relay_closed() const;
  void drive_relay(bool closed);

 private:
  SharedMemory& terminals_;
};

}  // namespace gs::shared_memory_io
