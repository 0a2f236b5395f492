// The threshold loss ΔP_s: the largest loss after which nothing has to be shed (§4, eq. 15, 18),
// and the load-shedding conditions by which outlets tell it, Table 1 of the paper.
#pragma once

#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::control_centre {

// ΔP_s, eq. (15), MW. Throws std::invalid_argument unless 0 < threshold_hz < f_n.
double threshold_mw(const grid::SfrModel& model, double threshold_hz);

// The threshold by which outlets that act `delay_s` after a loss keep its nadir at threshold_hz:
// eq. (15) takes shedding to be instant, so that less is shed than it takes. It is the same for a
// delay of 0, and the lower the later and the larger the loss: take the largest that is to be met.
// Where no shedding helps any more, below which the nadir comes before the delay has passed, 0.
// Throws std::invalid_argument as threshold_mw does, or for a negative loss or delay.
double threshold_for_delay_mw(const grid::SfrModel& model, double threshold_hz, double loss_mw,
                              double delay_s);

// K^LSE of eq. (18), MW per Hz/s, negative.
double k_lse_mw_per_hz_s(const grid::SfrModel& model);

// One row: for from_hz <= f < to_hz the condition is met while ROCOF is below the limit.
struct Condition {
  double from_hz;
  double to_hz;
  double rocof_below_hz_s;  // the threshold loss's ROCOF where it passes from_hz, <= 0
};

// For rows of any height, from f_n down to f_s; the last row may be lower than the others. Throws
// std::invalid_argument as threshold_mw does, or where row_hz < grid::kLowestConditionRow_hz.
std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz);

}  // namespace gsbench::control_centre
