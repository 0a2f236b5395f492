// Harmonics of real order, and of whole orders above those of the series (sine.hpp).
#pragma once

#include "excess_phase.hpp"
#include "schedule.hpp"
#include "sine.hpp"

#include <cstdint>
#include <vector>

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

// The highest order that the series renders; each order of it costs as much as the fundamental.
constexpr int kHighestOfSeries = 50;
bool is_of_series(const Harmonic& harmonic);

class Partials {
 public:
  Partials(const std::vector<Harmonic>& harmonics, double nominal_hz, std::int64_t sample_rate_hz);

  // Adds them to `count` samples from `first` on, counted from the block's start at block_tick.
  // `fundamental`: the stretch of the fundamental there, without its base_cycles.
  void add(std::int64_t block_tick, const SmoothPiece& piece, const ScheduleEntry& signal,
           const Stretch& fundamental, int first, int count, float* out) const;

 private:
  struct Partial {
    double order;
    NominalPhase nominal_phase;  // of its own frequency
    double amplitude_pu;         // of the fundamental
    double phase_cycles;
  };

  std::vector<Partial> partials_;
};

}  // namespace gsbench::waveform
