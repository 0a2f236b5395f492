// Pages of a report on a fleet after a loss in any grid: which outlets shed, how much and when, and
// the frequency, compared with other controls.
#pragma once

#include <optional>
#include <vector>

#include <campaign/work.hpp>
#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>
#include <grid/grid.hpp>
#include <profile/plan.hpp>
#include <record/page.hpp>

namespace gsbench::fleet {

// Every combination of loss, noise and delay is simulated.
struct Sweep {
  std::vector<double> losses_mw;  // empty: 0.9 … 2 times the grid's threshold loss
  // Noise of a measured frequency, as ScenarioOptions::noise_hz.
  std::vector<double> noises_hz = {0.0, 0.005, 0.01, 0.02, 0.05};
  std::vector<double> delays_s = {0.0, 0.1, 0.2, 0.5, 1.0};  // ScenarioOptions::further_delay_s
};

struct Study {
  FleetOptions fleet;
  ScenarioOptions scenario;  // `control` is not used: all controls are simulated
  bool delay_aware = false;  // adds Grid Sense with a threshold loss that allows for the delay
  bool closed_loop = false;  // adds a thousand outlets with the whole firmware
  std::optional<Sweep> sweep;
};

// Blocks until all is simulated or `execution` is stopped. A page that was stopped has the results
// so far and a fact "stopped". Throws std::invalid_argument for options out of range.
record::Page make_page(const grid::Grid& grid, const Study& study,
                       const campaign::Execution& execution);

// The page of a profile in a closed loop, with every strategy that is possible, and whether the
// outlets meet the limits of fleet/limits.hpp. The fleet has the plan's seed. Blocks and throws as
// make_page() and simulate_closed_loop() do.
record::Page make_closed_loop_page(const profile::Plan& plan, const Study& study,
                                   const campaign::Execution& execution);

// The same for each of many profiles, as one table of the judged figures. JSON has the list
// "scenarios" with all strategies. The page fails if one profile does; profiles that are not judged
// do not count.
record::Page make_scenarios_page(const std::vector<profile::Plan>& plans, const Study& study,
                                 const campaign::Execution& execution);

}  // namespace gsbench::fleet
