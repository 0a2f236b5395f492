// What the processor is told to do, in its memory. Addresses are the emulated board's own.
#pragma once

#include <cstdint>

#include <outlet/event_detector.hpp>

namespace gs::test {

// In the board's PSRAM, of which its firmware uses the beginning alone.
constexpr std::uint32_t kCodeAddress = 0x21800000;
constexpr std::uint32_t kReturnAddress = 0x21801000;
constexpr std::uint32_t kDataAddress = 0x21802000;

struct Calls {
  std::uint32_t begin = 0;  // functions of the image
  std::uint32_t observe = 0;
  std::uint32_t settings = 0;
  std::uint32_t line = 0;
  std::uint32_t deviations_hz = 0;  // trajectory by trajectory
  std::uint32_t states = 0;         // one a trajectory, in which it ends
  std::uint32_t trajectories = 0;
  std::uint32_t samples = 0;  // of each
  float nominal_hz = 0.0F;
  outlet::Baseline baseline;
};

}  // namespace gs::test
