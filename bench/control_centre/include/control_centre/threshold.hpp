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

// Until an outlet has acted: its decision, at most 0.96 s after the loss (§6.5), and its relay, 8
// ms.
constexpr double kOutletDelay_s = 0.968;

// Credible loss per threshold loss by eq. (15), for a grid that does not state its own. The paper's
// case is 500 MW for 351.92 MW.
constexpr double kCredibleLossFactor = 1.4;

// The loss for which settings allow for the delay: the grid's credible_loss_mw, or its default.
double credible_loss_mw(const grid::Grid& grid);

// The threshold loss by gsbench's rules: after the credible loss, outlets that act kOutletDelay_s
// later keep the nadir at f_s. If the frequency is below f_s by then, they keep it within 10 mHz of
// the highest possible: for the last millihertz the whole loss would have to be shed. At most that
// of eq. (15). A constant threshold is right for one loss; after a smaller one outlets shed too
// much, at most eq. (15) less this threshold, 11.8 MW on ieee24. Throws GridError if the grid is
// invalid.
double delay_aware_threshold_mw(const grid::Grid& grid);

// threshold_mw() or delay_aware_threshold_mw().
double threshold_mw(const grid::Grid& grid, Rules rules);

// K^LSE of eq. (18), MW per Hz/s, negative.
double k_lse_mw_per_hz_s(const grid::SfrModel& model);

// One row: for from_hz <= f < to_hz the condition is met if ROCOF is below the limit.
struct Condition {
  double from_hz;
  double to_hz;
  double rocof_below_hz_s;  // ROCOF after the threshold loss when f passes from_hz, <= 0
};

// Rows from f_n down to f_s, each row_hz wide; the last one may be narrower. Throws
// std::invalid_argument like threshold_mw, and if row_hz < grid::kLowestConditionRow_hz.
std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz);

}  // namespace gsbench::control_centre
