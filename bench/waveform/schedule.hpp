// The combined effect of a signal's amplitude steps and phase steps at each tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

// Valid from `from_tick` until the next entry.
struct ScheduleEntry {
  std::int64_t from_tick;
  double level;          // product of the active amplitude steps; 1 is nominal
  double offset_cycles;  // fraction of `turns`, within [0, 1)
  double turns;          // initial phase plus all phase steps so far, cycles
};

class Schedule {
 public:
  Schedule(const SignalSpec& spec, std::int64_t sample_rate_hz);

  std::size_t index_at(std::int64_t tick) const;
  const ScheduleEntry& operator[](std::size_t index) const { return entries_[index]; }
  std::int64_t end_tick(std::size_t index) const;

 private:
  std::vector<ScheduleEntry> entries_;  // ascending; the first one is at tick 0
};

}  // namespace gsbench::waveform
