// Detects an inter-area oscillation of 0.1 … 1 Hz that is superposed on the grid's frequency. Eight
// filters process the same measurements; each one starts at another frequency of the oscillation.
// After one period of the oscillation (at least 1.44 s) one of the filters has converged to it, and
// the follower may continue with it.
#pragma once

#include <outlet/grid_filter.hpp>

namespace gs::outlet {

constexpr int kSwingFilters = 8;

struct SwingBank {
  GridFilter filters[kSwingFilters];
  // Log-likelihood of each filter, weighted exponentially over about 100 measurements, without the
  // terms that are the same for all filters.
  float likelihood[kSwingFilters] = {};
  // Mean of the squares of the normalised innovations, weighted exponentially over about 33
  // measurements from 0 on; 1 if they fit.
  float innovation_squares[kSwingFilters] = {};
  std::uint16_t age = 0;  // reports since the start, up to 65535
};

// Starts all filters in equilibrium at a measured phase (cycles, variance in cycles²) and at
// `deviation_hz` from nominal.
void start(const Response& response, SwingBank& bank, float phase_cycles, float phase_variance,
           float deviation_hz);

// The phase in one report.
struct PhaseMeasurement {
  float phase_cycles = 0.0f;  // relative to nominal
  float variance = 0.0f;      // cycles², > 0 if measured
  bool measured = false;      // false: the voltage was disturbed, and the phase is not used
  bool after_gap = false;     // the first one after a disturbance: the phase may have jumped
};

// Moves filter `number`, 0 … kSwingFilters − 1, by one report. To spread the work, the filters may
// be moved one at a time, in ascending order. All must be moved before the next report.
void follow(const GridStep& step, SwingBank& bank, int number, float loss_noise_mw2,
            const PhaseMeasurement& measurement);

// The most likely filter, if its oscillation is established; otherwise nullptr. It is established
// if its amplitude is significant (above 12 mHz and six standard deviations), at least one of its
// periods and 1.44 s have passed since the start, and its innovations fit.
const GridFilter* established(const SwingBank& bank);

}  // namespace gs::outlet
