#include "run_steps.hpp"
#include <control_centre/conditions.hpp>
#include <control_centre/threshold.hpp>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>

namespace gsbench::station {

std::vector<record::Comparison> comparisons(const grid::Grid& grid) {
  const grid::Reference& reference = grid.reference;
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  std::vector<record::Comparison> all;
  if (reference.threshold_mw) {
    all.push_back({"threshold power loss", "MW", threshold_mw, *reference.threshold_mw, ""});
  }
  if (reference.t_nadir_s) {
    all.push_back({"time of the nadir", "s", grid::nadir(model, threshold_mw).t_s,
                   *reference.t_nadir_s, reference.note});
  }
  const std::vector<control_centre::Condition> rows =
      control_centre::conditions(model, grid.threshold_hz, grid.condition_row_hz);
  for (std::size_t row = 0; row < rows.size() && row < reference.condition_rocof_hz_s.size();
       ++row) {
    all.push_back({fmt::format("condition {:.2f} … {:.2f} Hz, ROCOF below", rows[row].from_hz,
                               rows[row].to_hz),
                   "Hz/s", rows[row].rocof_below_hz_s, reference.condition_rocof_hz_s[row], ""});
  }
  return all;
}

}  // namespace gsbench::station
