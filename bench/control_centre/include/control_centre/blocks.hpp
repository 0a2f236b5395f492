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

// P^A of an outlet in a block of group_mw, with less_important_mw shed before it.
double accumulated_mw(double less_important_mw, double group_mw,
                      Accumulation accumulation = Accumulation::kHalfGroup);

// f^B in stages over the accumulated power. Each block of eq. (17) has an f^B for itself, whatever
// is shed before it: a thousand blocks of 1 MW all have theirs within 10 mHz below f_s and switch
// off together. Staged, the backup acts like a droop that is kDroopFactor times as stiff as the
// grid itself, which loses f_n − f_s at its nadir for each threshold loss:
//   f^B(P^A) = f_s − (f_n − f_s)·(kMargin + P^A/(kDroopFactor·ΔP_s))
//
// kMargin: after one loss, outlets that shed by their estimate keep the nadir within 5 mHz of f_s.
// kDroopFactor: from 3 to 5, outlets that have f^B alone shed 0.8 to 1.0 times the power that keeps
// f_s if shed at once, after losses of 1.3 to 2.3·ΔP_s. They are 76 … 92 ms late, which does not
// matter because the fall is slow by then, also in a grid with a third of the inertia of ieee24
// (tests/bench/fleet/backup_test.cpp).
//
// P^A up to kDroopFactor·ΔP_s·((f_s − f)/(f_n − f_s) − kMargin) has its f^B above f: on ieee24 with
// the first under-frequency relays at 49 Hz, 1267 MW are shed before them.
class Stages {
 public:
  static constexpr double kMargin = 0.1;  // of f_n − f_s
  static constexpr double kDroopFactor = 4.0;

  // Throws GridError if the grid is invalid.
  explicit Stages(const grid::Grid& grid);

  double first_hz() const { return first_hz_; }  // f^B for P^A = 0
  double mw_per_hz() const { return mw_per_hz_; }
  // Falls with P^A; 0 or less for a P^A far beyond what the grid can lose.
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
  double switch_off_hz;   // f^B; all less important blocks are off
};

// The settings for each block of the grid, in the grid's order. Throws grid::GridError like
// grid::check, and if the switching-off frequency of a block is not above 0.
std::vector<BlockSetting> block_settings(const grid::Grid& grid,
                                         Accumulation accumulation = Accumulation::kHalfGroup,
                                         Rules rules = Rules::kGsbench);

// f^B of eq. (17) for a block of power_mw, with less_important_mw shed before it. Throws
// std::invalid_argument unless both are >= 0, their sum is at most load_mw, and the result is above
// 0. power_mw > 0 requires D > 0.
double eq17_switch_off_hz(const grid::Grid& grid, double less_important_mw, double power_mw);

}  // namespace gsbench::control_centre
