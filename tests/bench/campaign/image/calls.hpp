// The arguments of make_calls() in the processor's memory. Addresses are those of the emulated
// board.
#pragma once

#include <cstdint>

#include <outlet/event_detector.hpp>

namespace gs::test {

struct Calls {
  std::uint32_t begin = 0;  // functions of the image
  std::uint32_t observe = 0;
  std::uint32_t settings = 0;
  std::uint32_t line = 0;
  std::uint32_t deviations_hz = 0;  // all samples of a trajectory, then those of the next
  std::uint32_t states = 0;         // the final state of each trajectory
  std::uint32_t trajectories = 0;
  std::uint32_t samples = 0;  // of each trajectory
  float nominal_hz = 0.0F;
  outlet::Baseline baseline;
};

}  // namespace gs::test
