#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <grid/control_centre.hpp>
#include <grid/sfr_model.hpp>
#include <settings/grid_settings.hpp>

namespace gsbench::settings {
namespace {

// The LSE's standard deviation as a part of the threshold loss: noise and the tracker's memory
// together, from runs of 320 … 1000 MW.
constexpr double kLseSpread = 0.25;

void set_conditions(const grid::Grid& grid, const grid::SfrModel& model,
                    gs::outlet::Settings& settings) {
  const std::vector<grid::Condition> rows =
      grid::conditions(model, grid.threshold_hz, grid.condition_row_hz);
  if (rows.size() > gs::outlet::kMaxConditions) {
    throw std::invalid_argument("condition_row_hz makes " + std::to_string(rows.size()) +
                                " load-shedding conditions; an outlet keeps " +
                                std::to_string(gs::outlet::kMaxConditions) + " at most");
  }
  settings.condition_rows = static_cast<std::uint8_t>(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    settings.conditions[row] = {static_cast<float>(rows[row].from_hz),
                                static_cast<float>(rows[row].rocof_below_hz_s)};
  }
}

}  // namespace

gs::outlet::Settings grid_settings(const grid::Grid& grid) {
  const grid::SfrModel model(grid);
  const double threshold_mw = grid::threshold_mw(model, grid.threshold_hz);
  gs::outlet::Settings settings;
  settings.response.gain_hz_per_mw = static_cast<float>(model.gain_hz_per_mw());
  settings.response.sigma_per_s = static_cast<float>(model.sigma_per_s());
  settings.response.discriminant_per_s2 = static_cast<float>(model.discriminant_per_s2());
  settings.response.initial_slope_per_s = static_cast<float>(model.initial_slope_per_s());
  settings.threshold_mw = static_cast<float>(threshold_mw);
  settings.largest_loss_mw = static_cast<float>(grid.base_mw);
  set_conditions(grid, model, settings);
  settings.loss_sigma_mw = static_cast<float>(kLseSpread * std::min(threshold_mw, grid.base_mw));
  return settings;
}

}  // namespace gsbench::settings
