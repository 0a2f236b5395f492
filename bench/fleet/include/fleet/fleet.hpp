// Very many outlets in groups, and the load that they shed after a loss (§6.5). A group is a load
// block of the grid: its outlets have the same P^A and f^B.
#pragma once

#include <control_centre/blocks.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::fleet {

struct FleetOptions {
  std::size_t groups = 1000;     // load blocks, the least important first
  std::size_t per_group = 1000;  // outlets in each group
  double least_w = 10.0;         // power of an appliance, uniform between least and most
  double most_w = 1800.0;
  control_centre::Accumulation accumulation = control_centre::Accumulation::kHalfGroup;
  std::uint64_t seed = 1;
};

struct Fleet {
  std::size_t per_group = 0;
  std::vector<float> power_w;    // of each outlet's appliance; outlet n is in group n / per_group
  std::vector<double> group_mw;  // power of each group
  std::vector<double> accumulated_mw;  // P^A of each group
  double power_mw = 0.0;               // of all groups
  control_centre::Accumulation accumulation = control_centre::Accumulation::kHalfGroup;

  std::size_t outlets() const { return power_w.size(); }
  std::size_t groups() const { return group_mw.size(); }
};

constexpr std::size_t kMostOutlets = 100000000;

// Throws std::invalid_argument for no outlets, more than kMostOutlets, or powers out of range.
Fleet make_fleet(const FleetOptions& options);

// The power of a fleet in this many outlets, a group each.
FleetOptions in_fewer_outlets(const FleetOptions& options, std::size_t outlets);

// f^B of each group as a load block of this grid, Hz. Throws as control_centre::block_settings()
// does.
std::vector<double> switch_off_hz(const grid::Grid& grid, const Fleet& fleet,
                                  control_centre::Rules rules = control_centre::Rules::kGsbench);

struct Shed {
  double power_mw = 0.0;
  std::size_t outlets = 0;
  std::vector<std::uint32_t> off_in_group;
  std::size_t first_partly = 0;  // index of the first group that is not fully off
  std::size_t end_partly = 0;  // all outlets are on in the group with this index and in later ones
};

// `off`: a flag for each outlet; 0 means that the outlet is on.
Shed count_shed(const Fleet& fleet, const std::vector<std::uint8_t>& off);

// Whether this outlet sheds with this estimate of the loss: the firmware's rule, eq. (29).
bool sheds(const Fleet& fleet, std::size_t outlet, float loss_mw, float threshold_mw);

// loss_mw: the estimate of each outlet.
Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, float threshold_mw);

}  // namespace gsbench::fleet
