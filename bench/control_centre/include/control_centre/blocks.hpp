// The order of shedding: accumulated power P^A and switching-off frequency f^B of each load block.
#pragma once

#include <control_centre/rules.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include <grid/grid.hpp>

namespace gsbench::control_centre {

// The part of its own block that an outlet includes in P^A. kHalfGroup: a block is shed if the
// power to shed exceeds the middle of the block, so that the shed power is correct on average.
// kWholeGroup: eq. (11) as printed, which on average sheds half a block too little.
enum class Accumulation : std::uint8_t { kWholeGroup, kHalfGroup };

// P^A of an outlet in a block of group_mw; less_important_mw is the load that is shed before it.
double accumulated_mw(double less_important_mw, double group_mw,
                      Accumulation accumulation = Accumulation::kHalfGroup);

// f^B in stages: it falls with the accumulated power. By eq. (17), f^B depends little on what is
// shed before the block: a thousand blocks of 1 MW all have theirs within 10 mHz below f_s, and
// switch off together. In stages, the backup acts like a droop that is kDroopFactor times as stiff
// as the grid itself, whose nadir falls by f_n − f_s for each threshold loss:
//   f^B(P^A) = f_s − (f_n − f_s)·(kMargin + P^A/(kDroopFactor·ΔP_s))
//
// kMargin is a part of f_n − f_s. Outlets that shed by their estimate after a single loss keep the
// nadir within 5 mHz of f_s, which is above the first f^B.
// kDroopFactor may be 3 to 5. Outlets that have f^B alone then shed 0.8 to 1.0 times the power that
// would keep f_s if it were shed at once, after losses of 1.3 to 2.3·ΔP_s. They act 68 … 84 ms
// late there, and 64 … 82 ms late with the whole firmware without noise, which does not matter
// because the fall is slow by then. This also holds in a grid with a third of the inertia of ieee24
// (tests/bench/fleet/backup_test.cpp).
//
// f^B is above f for a P^A below kDroopFactor·ΔP_s·((f_s − f)/(f_n − f_s) − kMargin). On ieee24,
// 1267 MW are thus shed before the first under-frequency relays act at 49 Hz.
class Stages {
 public:
  static constexpr double kMargin = 0.1;  // of f_n − f_s
  static constexpr double kDroopFactor = 4.0;

  // Throws GridError if the grid is invalid.
  explicit Stages(const grid::Grid& grid);

  double first_hz() const { return first_hz_; }    // f^B for P^A = 0
  double mw_per_hz() const { return mw_per_hz_; }  // change of P^A per fall of f^B, > 0
  // f^B. It is 0 or less for a P^A far beyond what the grid can lose.
  double switch_off_hz(double accumulated_mw) const {
    return first_hz_ - accumulated_mw / mw_per_hz_;
  }

 private:
  double first_hz_, mw_per_hz_;
};

// One load block with the settings of its outlets.
struct BlockSetting {
  std::string id;
  double power_mw;
  double accumulated_mw;  // P^A
  double switch_off_hz;   // f^B
};

// The settings for each block of the grid, in the grid's order. Throws grid::GridError like
// grid::check, and if the switching-off frequency of a block is not above 0.
std::vector<BlockSetting> block_settings(const grid::Grid& grid,
                                         Accumulation accumulation = Accumulation::kHalfGroup,
                                         Rules rules = Rules::kGsbench);

// f^B of eq. (17) for a block of power_mw; less_important_mw is the load that is shed before it.
// f_s if power_mw is 0. Throws std::invalid_argument unless both are >= 0, their sum is at most
// load_mw, and the result is above 0, which requires D > 0 if power_mw is above 0.
double eq17_switch_off_hz(const grid::Grid& grid, double less_important_mw, double power_mw);

}  // namespace gsbench::control_centre
