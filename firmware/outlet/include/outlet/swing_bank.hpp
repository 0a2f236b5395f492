// Search for an inter-area oscillation of 0.1 … 1 Hz beneath the frequency. Eight filters, each
// with an oscillation near another frequency, follow the same measurements. Within one period of
// the oscillation one of them explains it; its state then serves as that of the follower.
#pragma once

#include <outlet/grid_filter.hpp>

namespace gs::outlet {

constexpr int kSwingFilters = 8;

struct SwingBank {
  GridFilter filters[kSwingFilters];
  float likelihood[kSwingFilters] = {};          // log, with a memory of 100 reports
  float innovation_squares[kSwingFilters] = {};  // mean of the normalised ones, 1 if they fit
  std::uint16_t age = 0;                         // reports since the start
};

// Starts all filters at a measured phase and the deviation `deviation_hz` from nominal.
void start(const Response& response, SwingBank& bank, float phase_cycles, float phase_variance,
           float deviation_hz);

// What a report brought.
struct PhaseMeasurement {
  float phase_cycles = 0.0f;  // relative to nominal
  float variance = 0.0f;      // cycles²
  bool measured = false;      // false: the voltage was disturbed
  bool after_gap = false;     // the first one after a disturbance: the phase may have jumped
};

// Moves filter `number` by one report. All must be moved for each report; they may be so at
// different times, to spread the work.
void follow(const GridStep& step, SwingBank& bank, int number, float loss_noise_mw2,
            const PhaseMeasurement& measurement);

// The filter that explains the measurements with an oscillation, or nullptr: its amplitude is
// significant, a whole period has passed since the start, and its innovations fit.
const GridFilter* established(const SwingBank& bank);

}  // namespace gs::outlet
