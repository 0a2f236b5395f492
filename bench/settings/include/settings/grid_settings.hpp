// What the control centre sends an outlet, in the firmware's own terms: the grid's part of it,
// which is the same for all outlets.
#pragma once

#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::settings {

// Response, threshold, largest loss, conditions and the spread of the LSE; the rest is as the
// firmware ships. No place in the order of shedding yet: accumulated_mw and switch_off_hz are 0.
// Throws std::invalid_argument where the grid makes no sense (GridError) or has more conditions
// than an outlet keeps.
gs::outlet::Settings grid_settings(const grid::Grid& grid);

}  // namespace gsbench::settings
