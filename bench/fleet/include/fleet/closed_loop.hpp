// A profile in a closed loop: its losses, disturbances of the voltage and noise are played into
// outlets, and the load that these switch off changes the frequency for all. Each outlet runs the
// whole firmware from the sampled voltage on, with its own noise and its own instants of report.
// Other controls of the same load are simulated for comparison. The profile's own outlets and
// commands are not used.
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
  double after_loss_s = 20.0;  // least simulated time after the profile's last loss
};

// What the outlets did; for strategies that have outlets.
struct OutletActions {
  std::size_t off = 0;     // switched off at any time
  std::size_t events = 0;  // detected an event after the first loss
  // Claimed an event before the first loss. Not known if the profile plays a recorded frequency.
  std::optional<std::size_t> false_events = 0;
  std::optional<double> latest_event_s;  // the latest of each outlet's first event after the loss
  campaign::Histogram loss_mw;           // estimates at the first decision

  explicit OutletActions(double base_mw) : loss_mw(0.0, 2.0 * base_mw, 2000) {}
};

struct ClosedLoopResult {
  double shed_mw = 0.0;   // the most that is off at any time
  double nadir_hz = 0.0;  // of the grid model
  double nadir_s = 0.0;
  double end_hz = 0.0;
  std::optional<double> first_action_s;  // load is switched off
  std::optional<double> last_action_s;
  std::optional<OutletActions> outlets;
  std::vector<double> t_s;  // every 20 ms
  std::vector<double> frequency_hz;
};

constexpr std::size_t kMostInClosedLoop = 100000;

// Times count from the start of the profile's signal. The result depends on the plan's seed, and
// not on the number of threads. Blocks until the end. Returns nothing if `execution` was stopped
// before. Throws std::invalid_argument for options out of range, too many outlets, settings that
// the firmware rejects, and a strategy that is not possible.
std::optional<ClosedLoopResult> simulate_closed_loop(const profile::Plan& plan, const Fleet& fleet,
                                                     Strategy strategy,
                                                     const ClosedLoopOptions& options,
                                                     const campaign::Execution& execution);

// The loss of the grid's power at_s as a profile, without a file, outlets and limits.
profile::Plan plan_of_loss(const grid::Grid& grid, double loss_mw, double at_s, double noise_pct,
                           std::uint64_t seed);

}  // namespace gsbench::fleet
