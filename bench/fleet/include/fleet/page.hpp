// Very many outlets of any grid after a loss: who sheds, how much, when, and how the frequency
// goes, beside other controls.
#pragma once

#include <optional>
#include <vector>

#include <campaign/work.hpp>
#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>
#include <grid/grid.hpp>
#include <record/page.hpp>

namespace gsbench::fleet {

// Each combination is played.
struct Sweep {
  std::vector<double> losses_mw;  // none: 0.9 … 2 times the grid's threshold
  std::vector<double> noises_hz = {0.0, 0.005, 0.01, 0.02, 0.05};
  std::vector<double> delays_s = {0.0, 0.1, 0.2, 0.5, 1.0};  // of outlets beyond their own
};

struct Study {
  FleetOptions fleet;
  ScenarioOptions scenario;  // its control is each in turn
  bool delay_aware = false;  // also with a threshold that reckons with the outlets' delay
  bool closed_loop = false;  // also a thousand outlets with the whole firmware
  std::optional<Sweep> sweep;
};

// Throws as the campaigns do. Stopped, it holds what was done so far, and says so.
record::Page make_page(const grid::Grid& grid, const Study& study,
                       const campaign::Execution& execution);

}  // namespace gsbench::fleet
