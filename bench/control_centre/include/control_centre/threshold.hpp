// The threshold loss ΔP_s, the largest loss that requires no load shedding (§4, eq. 15, 18), and
// the load-shedding conditions by which outlets recognise a larger loss (Table 1).
#pragma once

#include <control_centre/rules.hpp>

#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::control_centre {

// ΔP_s, eq. (15), MW. Throws std::invalid_argument unless 0 < threshold_hz < f_n.
double threshold_mw(const grid::SfrModel& model, double threshold_hz);

// The threshold loss that allows for the delay, MW. With it, outlets that act `delay_s` after the
// loss `loss_mw` keep the nadir at threshold_hz. Eq. (15) assumes immediate shedding; with its
// threshold loss, delayed outlets shed too little. The result equals eq. (15) for a delay of 0, and
// decreases with the delay and the loss; use the largest loss to be covered. 0 if the nadir is
// below threshold_hz even when the whole loss is shed. Throws std::invalid_argument like
// threshold_mw, and for a negative loss or delay.
double threshold_for_delay_mw(const grid::SfrModel& model, double threshold_hz, double loss_mw,
                              double delay_s);

// Time from a loss to an outlet's action: the decision at most 0.96 s after the loss (§6.5), and 8
// ms of the relay.
constexpr double kOutletDelay_s = 0.968;

// Credible loss / threshold loss by eq. (15), for a grid that does not state its credible loss. In
// the paper's case it is 500 MW / 351.92 MW.
constexpr double kCredibleLossFactor = 1.4;

// The loss for which settings allow for the delay, MW: the grid's credible_loss_mw, or else
// kCredibleLossFactor times the threshold loss by eq. (15).
double credible_loss_mw(const grid::Grid& grid);

// The threshold loss by gsbench's rules, MW, at most that of eq. (15). With it, outlets that act
// kOutletDelay_s after the credible loss keep the nadir at f_s. If that is out of reach or nearly
// so, they keep the nadir 10 mHz below the highest possible one: for the last millihertz the whole
// loss would have to be shed. The threshold is exact for the credible loss alone. After a smaller
// loss outlets shed too much, at most the difference from eq. (15), 11.8 MW on ieee24. Throws
// GridError if the grid is invalid.
double delay_aware_threshold_mw(const grid::Grid& grid);

// The threshold loss by these rules, MW: threshold_mw() or delay_aware_threshold_mw().
double threshold_mw(const grid::Grid& grid, Rules rules);

// K^LSE of eq. (18), MW per Hz/s, negative.
double k_lse_mw_per_hz_s(const grid::SfrModel& model);

// One row of Table 1. For from_hz <= f < to_hz the condition is met if the ROCOF is below the
// limit.
struct Condition {
  double from_hz;
  double to_hz;
  double rocof_below_hz_s;  // ROCOF after the threshold loss when f passes from_hz, <= 0
};

// Rows from f_n down to f_s, each row_hz wide; the last one may be narrower. Throws
// std::invalid_argument like threshold_mw, and if row_hz < grid::kLowestConditionRow_hz.
std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz);

}  // namespace gsbench::control_centre
