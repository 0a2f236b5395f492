// What the control centre sends an outlet, in the firmware's own terms: derived from the grid (§4),
// as real outlets get it. The firmware never sees the grid itself.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::control_centre {

// What is wanted of one outlet; what is absent follows from the grid, or is the firmware's default.
struct Wishes {
  double accumulated_mw = 0.0;             // P^A as sent, >= 0
  std::optional<double> power_mw;          // of its own block, half of which P^A counts
  std::map<std::string, double> settings;  // by the names of outlet/settings.hpp
};

// The grid's part, which is the same for all outlets: response, threshold, largest loss, conditions
// and the spread of the LSE; the rest is the firmware's default. No place in the order of shedding
// yet: accumulated_mw and switch_off_hz are 0. Throws std::invalid_argument where the grid makes no
// sense (GridError) or has more conditions than an outlet keeps.
gs::outlet::Settings grid_settings(const grid::Grid& grid);

// All of one outlet's. f^B is that of a block of power_mw (as much as accumulated_mw where absent),
// half of which is counted in accumulated_mw; of no load at all it is the threshold frequency.
// Throws std::invalid_argument, also where the firmware would refuse them.
gs::outlet::Settings outlet_settings(const grid::Grid& grid, const Wishes& wishes,
                                     std::uint32_t version);

// Every field by its name, for the record; of the conditions condition_rows, condition_01_from_hz,
// condition_01_rocof_below_hz_s, …
std::map<std::string, double> described(const gs::outlet::Settings& settings);

}  // namespace gsbench::control_centre
