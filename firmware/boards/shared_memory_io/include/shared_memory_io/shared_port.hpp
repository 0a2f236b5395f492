// The outlet's side of the terminals: reads samples, drives the relay's coil. No call blocks.
#pragma once

#include <shared_memory_io/shared_memory.hpp>

#include <cstddef>
#include <cstdint>

namespace gs::shared_memory_io {

class SharedPort {
 public:
  explicit SharedPort(SharedMemory& terminals) : terminals_(terminals) {}

  // Counts the start and skips samples written before it.
  void start();

  bool samples_wait() const { return terminals_.written != terminals_.taken; }
  // Takes up to `most` of the oldest samples and returns the number taken. Sets `lost` to the
  // number of samples lost before them because the bench had overwritten the ring.
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost);

  bool relay_closed() const;
  void drive_relay(bool closed);

 private:
  SharedMemory& terminals_;
};

}  // namespace gs::shared_memory_io
