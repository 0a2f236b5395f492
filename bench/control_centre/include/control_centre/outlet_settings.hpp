// The settings that the control centre sends to an outlet, derived from the grid (§4). The firmware
// does not know the grid itself.
#pragma once

#include <control_centre/rules.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::control_centre {

// Requested settings of one outlet. Settings that are not requested are derived from the grid or
// are the firmware's defaults.
struct RequestedSettings {
  double accumulated_mw = 0.0;     // P^A as sent, >= 0
  std::optional<double> power_mw;  // of the outlet's block, for eq. (17); P^A has half of it
  std::map<std::string, double> settings;  // by the names in outlet/settings.hpp
  Rules rules = Rules::kGsbench;           // for settings that are not requested
  bool staged_backup = false;              // f^B by Stages, else by eq. (17)
};

// The settings that are the same for all outlets of a grid: response, threshold loss, largest
// loss, conditions and standard deviation of the LSE; the rest are the firmware's defaults.
// accumulated_mw and switch_off_hz are 0. Throws std::invalid_argument if the grid is invalid
// (GridError) or has more conditions than an outlet stores.
gs::outlet::Settings grid_settings(const grid::Grid& grid, Rules rules = Rules::kGsbench);

// All settings of one outlet. f^B, unless it is requested:
// - staged_backup: by Stages, from accumulated_mw. power_mw has no effect.
// - Otherwise by eq. (17). The power of the outlet's own block is power_mw, or accumulated_mw if
//   power_mw is not requested. The less important load is accumulated_mw minus half of that power.
//   If accumulated_mw is 0, f^B is the threshold frequency.
// Throws std::invalid_argument for invalid input and for settings that the firmware would refuse.
gs::outlet::Settings outlet_settings(const grid::Grid& grid, const RequestedSettings& requested,
                                     std::uint32_t version);

// The largest P^A of an outlet without a requested power and f^B, MW: by eq. (17), f^B is then the
// least that the firmware accepts, or its block and the less important load are the whole load.
double largest_accumulated_mw(const grid::Grid& grid);

// The value of every field by its name, for the run record. The conditions have the names
// condition_rows, condition_01_from_hz, condition_01_rocof_below_hz_s, …
std::map<std::string, double> described(const gs::outlet::Settings& settings);

}  // namespace gsbench::control_centre
