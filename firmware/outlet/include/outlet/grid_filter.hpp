// Kalman filter that estimates the state of the grid from the measured phase of the voltage, and
// optionally an inter-area oscillation that is superposed.
//
// The measurement is z = φ + a, in cycles: φ is the phase of grid_model.hpp, a is the phase of the
// oscillation. The vector (a, b) rotates with the angular frequency Ω, which is estimated as well
// (extended Kalman filter). Without an oscillation a, b, Ω and their covariances are 0 and are not
// computed.
#pragma once

#include <outlet/front_end.hpp>
#include <outlet/grid_model.hpp>

namespace gs::outlet {

// Indices of the filter's state. The first four are those of GridVariable.
constexpr int kSwing = 4;        // a, cycles
constexpr int kSwingAcross = 5;  // b, cycles
constexpr int kSwingOmega = 6;   // Ω, rad/s
constexpr int kFilterStates = 7;
constexpr int kCovariances = kFilterStates * (kFilterStates + 1) / 2;

struct GridFilter {
  float x[kFilterStates] = {};          // φ within ± 0.5 cycles after each predict()
  float covariance[kCovariances] = {};  // upper triangle, row by row, in the units of the states
  bool with_swing = false;              // an oscillation is estimated
  // Log-likelihood of the measurements, weighted exponentially over about 100 of them, without the
  // terms that are the same for all filters.
  float likelihood = 0.0f;
};

// Index of the covariance of states i and j in GridFilter::covariance.
constexpr int covariance_index(int i, int j) {
  const int low = i < j ? i : j;
  const int high = i < j ? j : i;
  return low * kFilterStates - low * (low - 1) / 2 + high - low;
}

inline float variance(const GridFilter& filter, int state) {
  return filter.covariance[covariance_index(state, state)];
}

// The phase in one report.
struct PhaseMeasurement {
  float phase_cycles = 0.0f;  // relative to nominal; whole cycles do not matter
  float variance = 0.0f;      // cycles², > 0 if measured
  bool measured = false;      // false: the voltage was disturbed, and the phase is not used
  bool after_gap = false;     // the first one after a disturbance: the phase may have jumped
};

// Variances that a step of 16 ms adds to φ and p. Those of the other states are constants.
struct ProcessNoise {
  float phase = 0.0f;  // cycles²
  float loss = 0.0f;   // MW²
};

// Starts in equilibrium at `deviation_hz` from nominal: p = −Δf/K. Standard deviations: 0.5 Hz of
// Δf along the line of equilibria; from that line, 5 MW of p and 2 mHz/s of q; none of the phase,
// so that take_phase() must follow.
void start(const Response& response, GridFilter& filter, float phase_cycles, float deviation_hz);

// Adds an oscillation of unknown phase near `omega_rad_s`, in place of one that was there. Standard
// deviations: 0.05 Hz of its amplitude, 15 % of Ω. The estimate of Ω stays within 2π · 0.08 … 1.2
// Hz. The phase of the voltage does not jump when an oscillation begins: take_phase() must follow.
void add_swing(GridFilter& filter, float omega_rad_s);
void remove_swing(GridFilter& filter);

// Amplitude (peak) of the oscillation in the frequency, Hz, and its standard deviation. 0 without
// an oscillation.
float swing_hz(const GridFilter& filter);
float swing_sigma_hz(const GridFilter& filter);

// One step of 16 ms. `step` is that of kReport_s.
void predict(const GridStep& step, GridFilter& filter, const ProcessNoise& noise);

// Updates the state with a measurement, and counts its innovation in the likelihood. The first
// measurement after a gap only sets φ. Returns the innovation in its own standard deviations; 0
// without a measurement, or if only φ was set.
float correct(GridFilter& filter, const PhaseMeasurement& m);

// Adds to the covariances what independent changes of p in each of the last `steps` steps would
// have caused by now, each with a variance of `loss_mw2`.
void open_loss(const GridStep& step, GridFilter& filter, float loss_mw2, int steps);

// Sets φ from a measured phase and leaves all other states unchanged. For the first measurement,
// and for the one after a gap in which the phase may have jumped.
void take_phase(GridFilter& filter, const PhaseMeasurement& m);

}  // namespace gs::outlet
