// Kalman filter that follows the grid by the measured phase of the voltage: phase, frequency, lost
// power, and optionally an oscillation that lies over them.
//
// Measured is z = φ + a, in cycles: φ the phase of grid_model.hpp, a that of an inter-area
// oscillation. The oscillation is a rotating vector (a, b) of angular frequency Ω, which is
// estimated with it (extended Kalman filter). Without an oscillation its variances are 0, and its
// states are not computed.
#pragma once

#include <outlet/front_end.hpp>
#include <outlet/grid_model.hpp>

namespace gs::outlet {

// Indices of the filter's state; the first four are those of GridVariable.
constexpr int kSwing = 4;        // a, cycles
constexpr int kSwingAcross = 5;  // b, cycles
constexpr int kSwingOmega = 6;   // Ω, rad/s
constexpr int kFilterStates = 7;
constexpr int kCovariances = kFilterStates * (kFilterStates + 1) / 2;

struct GridFilter {
  float x[kFilterStates] = {};
  float covariance[kCovariances] = {};  // upper triangle, row by row
  bool with_swing = false;
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

// Process noise of a step, as variances.
struct ProcessNoise {
  float phase = 0.0f;  // cycles²
  float loss = 0.0f;   // MW²
};

// Starts in equilibrium: the lost power is the one whose final deviation is `deviation_hz`, known
// to ± 20 mHz.
void start(const Response& response, GridFilter& filter, float phase_cycles, float deviation_hz);

// Adds an unknown oscillation near `omega_rad_s`.
void add_swing(GridFilter& filter, float omega_rad_s);
// Removes the oscillation from the state.
void remove_swing(GridFilter& filter);

// Amplitude of the oscillation's frequency, Hz, and its standard deviation.
float swing_hz(const GridFilter& filter);
float swing_sigma_hz(const GridFilter& filter);

// One step of 16 ms.
void predict(const GridStep& step, GridFilter& filter, const ProcessNoise& noise);

struct Innovation {
  float normalised = 0.0f;      // per standard deviation
  float relative_width = 1.0f;  // its variance, per variance of the measurement
};

// Takes a measured phase, cycles; whole cycles do not matter.
Innovation correct(GridFilter& filter, float phase_cycles, float phase_variance);

// Takes the phase as measured and nothing else: after a gap in which the phase may have jumped.
void take_phase(GridFilter& filter, float phase_cycles, float phase_variance);

}  // namespace gs::outlet
