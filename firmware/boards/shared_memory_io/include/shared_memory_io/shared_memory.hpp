// The terminals: shared memory in place of an emulated outlet's hardware. They hold the samples for
// the ADC, the changes of the relay's coil, the manufacturing data and the flash. The outlet's
// board code accesses them like registers. The bench maps the same file.
//
// Each counter has one writer. The writer stores the data first, then advances the counter.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/messages.hpp>

namespace gs::shared_memory_io {

constexpr std::uint32_t kMagic = 0x47535431u;     // "GST1"
constexpr std::uint32_t kRingSamples = 1u << 16;  // 8 s at 8 kHz
constexpr std::uint32_t kPinEdges = 256;
constexpr std::size_t kFlashSlotBytes = 4096;
constexpr std::size_t kFlashSlots = 2;

struct PinEdge {
  std::uint32_t sample;  // ADC sample count when the pin changed
  std::uint32_t closed;  // 1: commanded to close
};

struct SharedMemory {
  // Written by the bench before the outlet starts.
  std::uint32_t magic;
  std::int32_t sample_rate_hz;
  std::int32_t nominal_hz;
  float counts_per_pu;
  std::uint32_t instance;
  char id[wire::kLongestId + 1];
  std::uint8_t crystal_fails;  // 1: the board behaves as if its crystal did not start

  // Samples of the mains voltage. The bench writes ring[written % kRingSamples], then increments
  // `written`; the outlet advances `taken`. Both counters run modulo 2^32.
  alignas(64) volatile std::uint32_t written;
  alignas(64) volatile std::uint32_t taken;

  // The relay's coil: number of changes of the pin, and the newest kPinEdges of them.
  alignas(64) volatile std::uint32_t edges;
  PinEdge edge[kPinEdges];

  volatile std::uint32_t starts;  // number of starts of the outlet

  // Like flash: an erase sets bytes to 0xFF, programming only clears bits.
  alignas(64) std::uint8_t flash[kFlashSlots][kFlashSlotBytes];

  alignas(64) std::int16_t ring[kRingSamples];
};

}  // namespace gs::shared_memory_io
