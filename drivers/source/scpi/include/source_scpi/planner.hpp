// Computes what a waveform generator would play for a stimulus, before anything is sent.
//
// One waveform is played, once: a soft rise of the voltage, nominal voltage while outlets boot and
// for a margin, the stimulus, and a soft fall to 0 V.
#pragma once

#include <source_scpi/instrument.hpp>

#include <cstdint>
#include <vector>

#include <source/source.hpp>

namespace gsbench::scpi {

// The largest deviations that are accepted.
struct Tolerances {
  double frequency_hz = 0.001;  // over windows of 200 ms, with the error of the clock
  double voltage_pu = 0.01;     // of a sample, without the error of the amplitude
  double time_s = 0.001;        // of a tick, early or late
};

struct Wiring {
  double nominal_v = 230.0;        // RMS at the outlets
  double gain = 100.0;             // V at the outlets per V at the instrument's terminals
  double voltage_limit_v = 253.0;  // RMS at the outlets; no sample may be beyond √2 times it
};

struct PlanOptions {
  Wiring wiring;
  double boot_s = 10.0;  // nominal voltage before the stimulus, for outlets to boot
  Tolerances tolerances;
  // Shorter only for tests.
  double rise_s = 0.5;
  double margin_s = 1.0;  // nominal voltage after boot_s, in which start() must be called
  double fall_s = 0.5;
};

struct Plan {
  source::Played played;
  double rate_hz = 0.0;             // points a second
  double frequency_hz = 0.0;        // repetitions a second of all codes
  double amplitude_vpp = 0.0;       // at the instrument's terminals
  double lead_s = 0.0;              // from the first point to tick 0 of the stimulus
  double duration_s = 0.0;          // from the first point to 0 V
  std::vector<std::int32_t> codes;  // of the DAC, one for each point
  std::int32_t largest_nudge = 0;   // codes moved off a forbidden byte, in codes
  std::int64_t bytes() const { return 2 * static_cast<std::int64_t>(codes.size()); }
};

// Highest voltage that the instrument can be set to within the voltage limit, per unit of nominal
// peak.
double full_scale_pu(const Instrument& instrument, const Wiring& wiring);

// Refuses, with value and limit, what exceeds memory, rate, amplitude, voltage limit or a
// tolerance. Blocks for about 1 s for each 10 min of stimulus.
[[nodiscard]] drivers::Result<Plan> make_plan(const source::Stimulus& stimulus,
                                              const Instrument& instrument,
                                              const PlanOptions& options);

}  // namespace gsbench::scpi
