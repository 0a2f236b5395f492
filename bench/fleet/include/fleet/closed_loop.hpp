// A profile in a closed loop. Its losses, disturbances of the voltage and noise are played into
// outlets, and the load that they switch off changes the frequency for all. Each outlet runs the
// whole firmware, from the sampled voltage on, with its own noise and its own instants of report.
// Other controls of the same load are simulated for comparison. The outlets and commands of the
// profile are not used.
#pragma once

#include <optional>
#include <vector>

#include <campaign/work.hpp>
#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>
#include <fleet/strategy.hpp>
#include <profile/plan.hpp>

namespace gsbench::fleet {

struct ClosedLoopOptions : Controls {
  double after_loss_s = 20.0;  // 1 … 300; least simulated time after the end of the last loss
};

// What the outlets did, for strategies that have outlets. Counts are numbers of outlets.
struct OutletActions {
  std::size_t off = 0;     // that were off at any time
  std::size_t events = 0;  // that detected an event after the first loss
  // That detected an event before the first loss. Nothing if the profile plays a recorded
  // frequency.
  std::optional<std::size_t> false_events = 0;
  // Time of the latest of the outlets' first events after the first loss.
  std::optional<double> latest_event_s;
  campaign::Histogram loss_mw;  // each outlet's estimate at its first decision

  explicit OutletActions(double base_mw) : loss_mw(0.0, 2.0 * base_mw, 2000) {}
};

struct ClosedLoopResult {
  double shed_mw = 0.0;   // the largest power that was off at a time
  double nadir_hz = 0.0;  // lowest frequency of the grid model, without superposed oscillations
  double nadir_s = 0.0;
  double end_hz = 0.0;
  std::optional<double> first_action_s;  // first and last time at which load went off
  std::optional<double> last_action_s;
  std::optional<OutletActions> outlets;
  std::vector<double> t_s;           // every 20 ms, and the end
  std::vector<double> frequency_hz;  // of the grid model at t_s
};

constexpr std::size_t kMostInClosedLoop = 100000;

// Times count from the start of the profile's signal. The result depends on the plan's seed, but
// not on the number of threads. Blocks until the end. Returns nothing if `execution` was stopped
// before. Throws std::invalid_argument for options out of range, more than kMostInClosedLoop
// outlets, settings that the firmware rejects, and a strategy that is not possible.
std::optional<ClosedLoopResult> simulate_closed_loop(const profile::Plan& plan, const Fleet& fleet,
                                                     Strategy strategy,
                                                     const ClosedLoopOptions& options,
                                                     const campaign::Execution& execution);

// A profile of a single loss at at_s, 0 < loss_mw <= the grid's base power; it has no file, outlets
// or limits. noise_pct is that of the voltage. Throws std::invalid_argument for a loss out of
// range.
profile::Plan plan_of_loss(const grid::Grid& grid, double loss_mw, double at_s, double noise_pct,
                           std::uint64_t seed);

}  // namespace gsbench::fleet
