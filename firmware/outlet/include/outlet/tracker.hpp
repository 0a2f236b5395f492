// Extended Kalman filter for the fundamental's phase, frequency and rate of change of frequency
// (ROCOF), with one measurement every 16 ms.
//
// State: amplitude A, phase φ relative to the nominal frequency, ω = dφ/dt, a = dω/dt (constant
// between steps, driven by white jerk). Observation: the phasor h = A·(cos φ, sin φ). Rotated by −φ
// and divided by A, the innovation splits into an amplitude error (real part) and a phase error
// (imaginary part). Their noise is independent, so that no covariance between amplitude and phase
// states is needed.
//
// Phase steps, dips and interruptions must not appear as frequency. An innovation gate, wider than
// the changes of a grid in 16 ms, detects them. While innovations are outside the gate, the filter
// coasts: it extrapolates without correction. After three reports within the gate, the filter takes
// phase and amplitude from the phasor and keeps its frequency. If it coasts for too long, it
// acquires the frequency again. A step of the ROCOF by more than 4 Hz/s exceeds the gate, too; the
// filter follows it eight reports later.
#pragma once

#include <cstdint>

#include <outlet/front_end.hpp>

namespace gs::outlet {

enum class Validity : std::uint8_t {
  kInvalid = 0,  // no voltage, or not settled: frequency and ROCOF are NaN
  kValid = 1,
  kHeld = 2,  // coasting over a disturbance: extrapolated, not measured
};

struct TrackerSettings {
  // Standard deviation of a measured phase, and density of the process's jerk. Their ratio sets the
  // bandwidth. The default phase noise is that of 1 % white noise at 8 kHz.
  float phase_noise_rad = 8.0e-4f;
  float jerk_rad_s3_per_sqrt_hz = 0.8f;
  // Innovation gate: limit of the innovation's change from report to report.
  float innovation_gate_rad = 0.015f;
  float innovation_gate_amplitude = 0.06f;  // relative to the amplitude
  float dead_bus_pu = 0.10f;  // no frequency below this; measured again above 1.5 × this
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
  // What the last report's correction left of its innovations.
  float last_innovation_rad = 0.0f;
  float last_innovation_amplitude = 0.0f;
  std::uint16_t age = 0;   // reports since acquisition
  std::uint8_t held = 0;   // reports since the last valid measurement
  std::uint8_t quiet = 0;  // while coasting: successive newest reports within the gate
  bool coasting = false;   // after an innovation outside the gate
  bool dead = true;
};

// One step of 16 ms.
Measurement track(const TrackerSettings& settings, float nominal_hz, TrackerState& state,
                  const Phasor& phasor);

}  // namespace gs::outlet
