// A fleet of outlets with the whole firmware, starting from the sampled voltage. Each outlet
// samples the mains with its own noise, and the load that it sheds changes the frequency for all.
// For small fleets: a thousand outlets need a second of processor time for three simulated seconds.
#pragma once

#include <optional>

#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>

namespace gsbench::fleet {

struct ClosedLoopOptions {
  double loss_mw = 500.0;
  double noise_pct = 1.0;     // σ of white noise on the voltage, % of its amplitude
  double threshold_mw = 0.0;  // threshold loss in the outlets' settings; 0: the grid's
  double duration_s = 20.0;   // after the loss; the loss is at 1 s
  std::uint64_t seed = 1;
};

struct ClosedLoopResult {
  ScenarioResult scenario;       // times count from the loss
  std::size_t events = 0;        // outlets whose first event is after the loss
  std::size_t false_events = 0;  // outlets whose first event is before the loss
  double latest_event_s = 0.0;   // after the loss; NaN if no outlet detected it
  campaign::Histogram loss_mw;   // estimates at the decision
};

constexpr std::size_t kMostInClosedLoop = 100000;

// Blocks until the end. Returns nothing if `execution` was stopped before. Throws
// std::invalid_argument for options out of range, or settings that the firmware rejects.
std::optional<ClosedLoopResult> simulate_closed_loop(const grid::Grid& grid, const Fleet& fleet,
                                                     const ClosedLoopOptions& options,
                                                     const campaign::Execution& execution);

}  // namespace gsbench::fleet
