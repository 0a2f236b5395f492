// The whole voltage that is loaded into a generator, at the rate of the stimulus.
#pragma once

#include <source_scpi/planner.hpp>

#include <cstdint>
#include <vector>

#include <source/source.hpp>

namespace gsbench::scpi {

// Parts of it, in samples at the rate of the stimulus.
struct LoadedTicks {
  LoadedTicks(const source::Stimulus& stimulus, const PlanOptions& options);
  std::int64_t lead;  // before tick 0 of the stimulus
  std::int64_t fall;  // after its end
  std::int64_t total;
};

struct LoadedWaveform {
  std::int64_t lead_ticks = 0;    // before tick 0 of the stimulus
  std::vector<float> voltage_pu;  // per unit of nominal peak; begins and ends at 0
};

// A soft rise, nominal voltage in phase with the beginning of the stimulus, the stimulus, and a
// soft fall at its last frequency, in phase with its end. In the last 0.1 s before the stimulus,
// the amplitude changes softly to that of its fundamental. Without the stimulus's noise.
LoadedWaveform loaded_waveform(const source::Stimulus& stimulus, const PlanOptions& options);

// The stimulus's noise alone, 0 before and after it; of the same size as `waveform`.
std::vector<float> noise_of(const source::Stimulus& stimulus, const LoadedWaveform& waveform);

}  // namespace gsbench::scpi
