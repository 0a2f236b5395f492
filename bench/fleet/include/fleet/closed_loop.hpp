// A fleet of outlets with the whole firmware, from the voltage on: each samples the mains with
// noise of its own, and what it sheds changes the mains for all. Small fleets: a thousand outlets
// take a second of processor time for three seconds played.
#pragma once

#include <optional>

#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>

namespace gsbench::fleet {

struct ClosedLoopOptions {
  double loss_mw = 500.0;
  double noise_pct = 1.0;     // σ of white noise on the voltage, % of its amplitude
  double threshold_mw = 0.0;  // that outlets are told; 0: the grid's
  double duration_s = 20.0;   // from the loss on, which comes after a second
  std::uint64_t seed = 1;
};

struct ClosedLoopResult {
  ScenarioResult scenario;       // its times count from the loss
  std::size_t events = 0;        // outlets that detected one
  std::size_t false_events = 0;  // before the loss
  double latest_event_s = 0.0;   // after the loss; NaN where there was none
  campaign::Histogram loss_mw;   // estimates at the decision
};

constexpr std::size_t kMostInClosedLoop = 100000;

// Throws std::invalid_argument for what makes no sense. Nothing where it was stopped before its
// end.
std::optional<ClosedLoopResult> play_closed_loop(const grid::Grid& grid, const Fleet& fleet,
                                                 const ClosedLoopOptions& options,
                                                 const campaign::Execution& execution);

}  // namespace gsbench::fleet
