// The order of shedding: what power an outlet compares with, P^A, and its switching-off frequency.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::control_centre {

// How much of its own block an outlet counts in P^A. kHalfGroup: a block goes off where the power
// to be shed passes the block's middle, so that what is shed is right on average. kWholeGroup is
// eq. (11) as printed: on average half a block too little is shed.
enum class Accumulation : std::uint8_t { kWholeGroup, kHalfGroup };

// P^A of an outlet whose block has group_mw, behind less_important_mw that is shed before it.
double accumulated_mw(double less_important_mw, double group_mw,
                      Accumulation accumulation = Accumulation::kHalfGroup);

// One load block with what its outlets are sent.
struct BlockSetting {
  std::string id;
  double power_mw;
  double accumulated_mw;  // P^A
  double switch_off_hz;   // f^B, eq. (17), summed over j = 1 … i−1
};

// For each block, in order. Throws grid::GridError as grid::check does, and where a block would
// have no switching-off frequency above 0.
std::vector<BlockSetting> block_settings(const grid::Grid& grid,
                                         Accumulation accumulation = Accumulation::kHalfGroup);

// f^B of eq. (17) for a block of power_mw behind less_important_mw. Throws std::invalid_argument
// unless both are >= 0, their sum is at most load_mw, and the result is above 0, which takes D > 0.
double switch_off_hz(const grid::Grid& grid, double less_important_mw, double power_mw);

}  // namespace gsbench::control_centre
