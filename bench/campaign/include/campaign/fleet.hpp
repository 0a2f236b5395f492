// Very many outlets in order of importance, and what they shed after a loss (§6.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::campaign {

// What an outlet compares its requirement with. kWholeGroup is eq. (11): the power up to its group
// and that of the group itself, so that on average half a group too little is shed. kHalfGroup
// takes half of its own group: a group goes off where the requirement passes its middle.
enum class Accumulation : std::uint8_t { kWholeGroup, kHalfGroup };

struct FleetOptions {
  std::size_t groups = 1000;     // in order of importance, the least important first
  std::size_t per_group = 1000;  // outlets
  double least_w = 10.0;         // of an appliance, uniform
  double most_w = 1800.0;
  Accumulation accumulation = Accumulation::kHalfGroup;
  std::uint64_t seed = 1;
};

struct Fleet {
  std::size_t per_group = 0;
  std::vector<float> power_w;    // of each outlet's appliance; outlet n is in group n / per_group
  std::vector<double> group_mw;  // of each group
  std::vector<double> accumulated_mw;  // what its outlets compare with
  double power_mw = 0.0;               // of all

  std::size_t outlets() const { return power_w.size(); }
  std::size_t groups() const { return group_mw.size(); }
};

constexpr std::size_t kMostOutlets = 100000000;

// Throws std::invalid_argument where there would be no outlets, or too many, or no power.
Fleet make_fleet(const FleetOptions& options);

struct Shed {
  double power_mw = 0.0;
  std::size_t outlets = 0;
  std::vector<std::uint32_t> off_in_group;
  std::size_t first_partly = 0;  // group from 0: all before it are wholly off
  std::size_t end_partly = 0;    // it and all after it are wholly on
};

// Who is off, by outlet.
Shed count_shed(const Fleet& fleet, const std::vector<std::uint8_t>& off);

// Each outlet by its own estimate of the loss (eq. 29): off where what it finds above the threshold
// is more than what it compares with.
Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, double threshold_mw);

}  // namespace gsbench::campaign
