// Very many outlets in order of importance, and what they shed after a loss (§6.5).
#pragma once

#include <control_centre/blocks.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::fleet {

struct FleetOptions {
  std::size_t groups = 1000;     // in order of importance, the least important first
  std::size_t per_group = 1000;  // outlets
  double least_w = 10.0;         // of an appliance, uniform
  double most_w = 1800.0;
  control_centre::Accumulation accumulation = control_centre::Accumulation::kHalfGroup;
  std::uint64_t seed = 1;
};

struct Fleet {
  std::size_t per_group = 0;
  std::vector<float> power_w;    // of each outlet's appliance; outlet n is in group n / per_group
  std::vector<double> group_mw;  // of each group
  std::vector<double> accumulated_mw;  // P^A
  double power_mw = 0.0;               // of all

  std::size_t outlets() const { return power_w.size(); }
  std::size_t groups() const { return group_mw.size(); }
};

constexpr std::size_t kMostOutlets = 100000000;

// Throws std::invalid_argument where there would be no outlets, or too many, or no power.
Fleet make_fleet(const FleetOptions& options);

// f^B of each group, as blocks of this grid. Throws as control_centre::block_settings() does.
std::vector<double> switch_off_hz(const grid::Grid& grid, const Fleet& fleet);

struct Shed {
  double power_mw = 0.0;
  std::size_t outlets = 0;
  std::vector<std::uint32_t> off_in_group;
  std::size_t first_partly = 0;  // group from 0: all before it are wholly off
  std::size_t end_partly = 0;    // it and all after it are wholly on
};

// Who is off, by outlet.
Shed count_shed(const Fleet& fleet, const std::vector<std::uint8_t>& off);

// Does this outlet shed by its own estimate of the loss: the firmware's rule, eq. (29).
bool sheds(const Fleet& fleet, std::size_t outlet, float loss_mw, float threshold_mw);

// Each outlet by its own estimate.
Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, float threshold_mw);

}  // namespace gsbench::fleet
