// The order of shedding: accumulated power P^A and switching-off frequency f^B of each load block.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::control_centre {

// The part of its own block that an outlet includes in P^A. kHalfGroup: a block is shed if the
// power to shed exceeds the middle of the block, so that the shed power is correct on average.
// kWholeGroup: eq. (11) as printed, which on average sheds half a block too little.
enum class Accumulation : std::uint8_t { kWholeGroup, kHalfGroup };

// P^A of an outlet in a block of group_mw, with less_important_mw shed before it.
double accumulated_mw(double less_important_mw, double group_mw,
                      Accumulation accumulation = Accumulation::kHalfGroup);

// One load block with the settings of its outlets.
struct BlockSetting {
  std::string id;
  double power_mw;
  double accumulated_mw;  // P^A
  double switch_off_hz;   // f^B, eq. (17); all less important blocks are off
};

// The settings for each block of the grid, in the grid's order. Throws grid::GridError like
// grid::check, and if the switching-off frequency of a block is not above 0.
std::vector<BlockSetting> block_settings(const grid::Grid& grid,
                                         Accumulation accumulation = Accumulation::kHalfGroup);

// f^B of eq. (17) for a block of power_mw, with less_important_mw shed before it. Throws
// std::invalid_argument unless both are >= 0, their sum is at most load_mw, and the result is above
// 0. power_mw > 0 requires D > 0.
double switch_off_hz(const grid::Grid& grid, double less_important_mw, double power_mw);

}  // namespace gsbench::control_centre
