// What an outlet with a crystal of its own says of the voltage that a run plays: the outlet's own
// firmware over samples of the played signal.
#pragma once

#include <cstdint>

#include <capture/clock.hpp>
#include <profile/plan.hpp>

namespace gsbench::capture::test {

struct Crystal {
  double ppm = 0.0;           // by how much it is fast
  std::int64_t lead_in = 0;   // samples that the outlet counted before the source began
  std::uint64_t started = 0;  // what its count began with
  std::uint32_t noise_index = 0;
};

struct Played {
  Markers markers;
  VoltageTrace trace;
  std::int64_t run_ticks = 0;

  // Where a count of the outlet's samples truly is on the run's ticks, and the other way round.
  double sample_at(double tick) const { return zero_sample + tick * samples_per_tick; }
  double zero_sample = 0.0;
  double samples_per_tick = 1.0;
};

Played play(const profile::Plan& plan, const Crystal& crystal);

}  // namespace gsbench::capture::test
