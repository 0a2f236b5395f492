// Up to 10⁸ outlets in groups, and the load that they shed after a loss (§6.5). A group is a load
// block of the grid; its outlets have the same P^A and f^B.
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
  // Power of an appliance, uniform between least_w >= 0 and most_w > 0, at most 10⁹ W.
  double least_w = 10.0;
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

// The same fleet with fewer outlets, > 0, each in a group of its own. Their power is larger, so
// that the expected total stays the same.
FleetOptions in_fewer_outlets(const FleetOptions& options, std::size_t outlets);

// f^B of each group as a load block of this grid, Hz. Throws as control_centre::block_settings()
// does.
std::vector<double> switch_off_hz(const grid::Grid& grid, const Fleet& fleet,
                                  control_centre::Rules rules = control_centre::Rules::kGsbench);

struct Shed {
  double power_mw = 0.0;
  std::size_t outlets = 0;
  std::vector<std::uint32_t> off_in_group;  // outlets that are off, by group
  std::size_t first_partly = 0;             // index of the first group that is not fully off
  std::size_t end_partly = 0;  // all outlets are on in the group with this index and in later ones
};

// `off`: one flag for each outlet; 0 means that it is on.
Shed count_shed(const Fleet& fleet, const std::vector<std::uint8_t>& off);

// Whether this outlet sheds with this estimate of the loss, by the firmware's rule of method 0,
// eq. (29).
bool sheds(const Fleet& fleet, std::size_t outlet, float loss_mw, float threshold_mw);

// What is shed if each outlet decides by sheds(). loss_mw: the estimate of each outlet.
Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, float threshold_mw);

}  // namespace gsbench::fleet
