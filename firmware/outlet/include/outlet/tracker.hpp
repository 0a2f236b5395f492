// Extended Kalman filter for the fundamental's phase, frequency and rate of change of frequency
// (ROCOF), a measurement every 16 ms.
//
// State: amplitude A, phase φ against the nominal frequency, ω = dφ/dt, a = dω/dt (constant between
// steps, driven by white jerk). Observation: the phasor h = A·(cos φ, sin φ). Turned by −φ and
// divided by A, its innovation parts into an amplitude error (real) and a phase error (imaginary)
// whose noise is independent, so that the four states need no covariance across the two.
//
// A phase jump, a dip or an interruption is no frequency: where the innovation exceeds its
// gate, more than grids move it in 16 ms, the filter coasts until three reports are within it, then
// takes phase and amplitude anew and keeps its frequency. Where this repeats it restarts. A step of
// the ROCOF by more than 4 Hz/s exceeds the gate too, and is followed eight reports later.
#pragma once

#include <cstdint>

#include <outlet/front_end.hpp>

namespace gs::outlet {

enum class Validity : std::uint8_t {
  kInvalid = 0,  // no voltage to measure, or not settled: frequency and ROCOF are NaN
  kValid = 1,
  kHeld = 2,  // coasting over a disturbance: the last valid course, not a measurement
};

struct TrackerSettings {
  // Standard deviations of a measured phase and of the process's jerk; their ratio sets the
  // bandwidth. The phase noise is that of 1 % white noise at 8 kHz.
  float phase_noise_rad = 8.0e-4f;
  float jerk_rad_s3_per_sqrt_hz = 0.8f;
  // The innovation's change from report to report that grids do not cause.
  float innovation_gate_rad = 0.015f;
  float innovation_gate_amplitude = 0.06f;  // the same for the amplitude, relative
  float dead_bus_pu = 0.10f;                // below: no frequency; above 1.5 × this: again
};

struct Measurement {
  float frequency_hz = 0.0f;  // NaN where invalid
  float rocof_hz_s = 0.0f;    // the filter's own, NaN where invalid
  float voltage_pu = 0.0f;    // RMS over 50 ms
  Validity validity = Validity::kInvalid;
};

struct TrackerState {
  float amplitude = 0.0f;
  float phase_rad = 0.0f;
  float omega_rad_s = 0.0f;  // deviation from nominal
  float alpha_rad_s2 = 0.0f;
  // Covariance of (φ, ω, a): pp, pw, pa, ww, wa, aa.
  float covariance[6] = {};
  // What the last report's innovations left after its corrections.
  float last_innovation_rad = 0.0f;
  float last_innovation_amplitude = 0.0f;
  std::uint16_t age = 0;   // reports since acquisition
  std::uint8_t held = 0;   // reports since the last measurement
  std::uint8_t quiet = 0;  // of these, the newest ones without a leap
  bool coasting = false;   // over a leap
  bool dead = true;
};

// One step of 16 ms.
Measurement track(const TrackerSettings& settings, float nominal_hz, TrackerState& state,
                  const Phasor& phasor);

}  // namespace gs::outlet
