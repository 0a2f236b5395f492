// The voltage reports of an outlet with its own crystal: the real firmware processes samples of the
// played signal.
#pragma once

#include <cstdint>

#include <capture/clock.hpp>
#include <profile/plan.hpp>

namespace gsbench::capture::test {

struct Crystal {
  double ppm = 0.0;           // rate error, positive if fast
  std::int64_t lead_in = 0;   // samples before the source starts
  std::uint64_t started = 0;  // first value of its sample count
  std::uint32_t noise_index = 0;
};

struct Played {
  Markers markers;
  VoltageTrace trace;
  std::int64_t run_ticks = 0;

  // Exact sample count of the outlet at a tick of the run.
  double sample_at(double tick) const { return zero_sample + tick * samples_per_tick; }
  double zero_sample = 0.0;
  double samples_per_tick = 1.0;
};

Played play(const profile::Plan& plan, const Crystal& crystal);

}  // namespace gsbench::capture::test
