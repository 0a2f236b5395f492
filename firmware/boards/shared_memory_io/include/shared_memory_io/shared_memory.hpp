// Shared memory in place of an emulated outlet's hardware: the mains at its ADC, the coil of its
// relay, what is written into it at manufacture, and its flash. The outlet's board code sees it as
// registers; the bench maps the same file. A real board has a converter, a pin and a flash instead.
//
// Each counter has one writer; the other side reads it after what it counts.
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
  std::uint32_t sample;  // the converter's count when the pin changed
  std::uint32_t closed;  // 1: the contact is to close
};

struct SharedMemory {
  // Written by the bench before the outlet starts.
  std::uint32_t magic;
  std::int32_t sample_rate_hz;
  std::int32_t nominal_hz;
  float counts_per_pu;
  std::uint32_t instance;
  char id[wire::kLongestId + 1];
  std::uint8_t crystal_fails;  // 1: the board behaves as one whose crystal does not start

  // The mains. The bench writes ring[written % kRingSamples], then counts; the outlet follows. Both
  // counters run modulo 2^32.
  alignas(64) volatile std::uint32_t written;
  alignas(64) volatile std::uint32_t taken;

  // The relay's coil: the newest kPinEdges changes of the pin, and how many there were.
  alignas(64) volatile std::uint32_t edges;
  PinEdge edge[kPinEdges];

  volatile std::uint32_t starts;  // how often the outlet has restarted

  // As flash: an erase sets bytes to 0xFF, programming only clears bits.
  alignas(64) std::uint8_t flash[kFlashSlots][kFlashSlotBytes];

  alignas(64) std::int16_t ring[kRingSamples];
};

}  // namespace gs::shared_memory_io
