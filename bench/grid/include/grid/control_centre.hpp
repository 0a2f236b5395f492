// What the control centre works out before any event (§4, eq. 11–18) and sends to the outlets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {

// One row of Table 1: for from_hz <= f < to_hz the condition is met while ROCOF is below the limit.
struct Condition {
  double from_hz;
  double to_hz;
  double rocof_below_hz_s;  // the threshold loss's ROCOF where it passes from_hz, <= 0
};

// One load block with what its outlets are told.
struct BlockSetting {
  std::string id;
  double power_mw;
  double accumulated_mw;  // P^A, eq. (11)
  double switch_off_hz;   // f^B, eq. (17), summed over j = 1 … i−1
};

struct Nadir {
  double t_s;  // +infinity where the frequency falls to its end value without a turn
  double frequency_hz;
};

// The paper's closed-form parameters of eq. (7)–(9), (12); they exist for zeta < 1 only.
struct UnderdampedParameters {
  double alpha;
  double omega_r;  // rad/s
  double phi;      // rad
  double phi1;     // rad, in (0, π)
};

std::optional<UnderdampedParameters> underdamped_parameters(const SfrModel& model, double reheat_s);

// Lowest frequency after one loss at t = 0, eq. (13), (14). Throws std::invalid_argument for a
// negative loss, which has a highest frequency instead.
Nadir nadir(const SfrModel& model, double loss_mw);

// ΔP_s, eq. (15), MW. Throws std::invalid_argument unless 0 < threshold_hz < f_n.
double threshold_mw(const SfrModel& model, double threshold_hz);

// The threshold by which outlets that act `delay_s` after a loss keep its nadir at threshold_hz:
// eq. (15) takes shedding to be instant, so that less is shed than it takes. It is the same for a
// delay of 0, and the lower the later and the larger the loss: take the largest that is to be met.
// Where no shedding helps any more, below which the nadir comes before the delay has passed, 0.
// Throws std::invalid_argument as threshold_mw does, or for a negative loss or delay.
double threshold_for_delay_mw(const SfrModel& model, double threshold_hz, double loss_mw,
                              double delay_s);

// K^LSE of eq. (18), MW per Hz/s, negative.
double k_lse_mw_per_hz_s(const SfrModel& model);

// Table 1 for rows of any height, from f_n down to f_s; the last row may be lower than the others.
// Throws std::invalid_argument as threshold_mw does, or where row_hz < kLowestConditionRowHz.
std::vector<Condition> conditions(const SfrModel& model, double threshold_hz, double row_hz);

// Eq. (11) and (17) for each block, in order. Throws GridError as check() does.
std::vector<BlockSetting> block_settings(const Grid& grid);

// Eq. (17) for one outlet of which only P^A is known: it stands as a block of its own of
// `power_mw` behind `accumulated_mw − power_mw` of less important load. Throws
// std::invalid_argument unless 0 <= power_mw <= accumulated_mw <= load_mw and the result is above
// 0, which takes D > 0.
double switch_off_hz(const Grid& grid, double accumulated_mw, double power_mw);

}  // namespace gsbench::grid
