#include <control_centre/blocks.hpp>
#include <control_centre/conditions.hpp>
#include <control_centre/outlet_settings.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::control_centre {
namespace {

// The LSE's standard deviation as a part of the threshold loss: noise and the tracker's memory
// together, from runs of 320 … 1000 MW.
constexpr double kLseSpread = 0.25;

void set_conditions(const grid::Grid& grid, const grid::SfrModel& model,
                    gs::outlet::Settings& settings) {
  const std::vector<Condition> rows = conditions(model, grid.threshold_hz, grid.condition_row_hz);
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

template <class Count>
void set_count(const std::optional<int>& wanted, const char* what, Count& field) {
  if (!wanted) {
    return;
  }
  if (*wanted < 0 || *wanted > std::numeric_limits<Count>::max()) {
    throw std::invalid_argument(std::string(what) + " = " + std::to_string(*wanted) +
                                " is out of the firmware's range");
  }
  field = static_cast<Count>(*wanted);
}

double switch_off_of(const grid::Grid& grid, const Wishes& wishes) {
  const double power_mw = wishes.power_mw.value_or(wishes.accumulated_mw);
  // What accumulated_mw() adds, taken off again.
  const double less_important_mw = wishes.accumulated_mw - accumulated_mw(0.0, power_mw);
  return switch_off_hz(grid, less_important_mw, power_mw);
}

}  // namespace

gs::outlet::Settings grid_settings(const grid::Grid& grid) {
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
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

gs::outlet::Settings outlet_settings(const grid::Grid& grid, const Wishes& wishes,
                                     std::uint32_t version) {
  gs::outlet::Settings settings = grid_settings(grid);
  const auto set = [](const std::optional<double>& wanted, float& field) {
    field = wanted ? static_cast<float>(*wanted) : field;
  };
  settings.version = version;
  set(wishes.threshold_mw, settings.threshold_mw);
  settings.accumulated_mw = static_cast<float>(wishes.accumulated_mw);
  settings.switch_off_hz = static_cast<float>(wishes.switch_off_hz ? *wishes.switch_off_hz
                                                                   : switch_off_of(grid, wishes));
  set(wishes.event_drop_hz, settings.event_drop_hz);
  set(wishes.event_departure_hz, settings.event_departure_hz);
  set_count(wishes.condition_hits, "condition_hits", settings.condition_hits);
  set_count(wishes.lse_samples, "lse_samples", settings.lse_samples);
  set_count(wishes.ekf_samples, "ekf_samples", settings.ekf_samples);
  const gs::outlet::SettingsError error =
      gs::outlet::validate(settings, static_cast<float>(grid.nominal_hz));
  if (error != gs::outlet::SettingsError::kNone) {
    throw std::invalid_argument(std::string("the firmware refuses these settings: ") +
                                gs::outlet::to_string(error));
  }
  return settings;
}

std::map<std::string, double> described(const gs::outlet::Settings& s) {
  return {
      {"version", static_cast<double>(s.version)},
      {"gain_hz_per_mw", static_cast<double>(s.response.gain_hz_per_mw)},
      {"sigma_per_s", static_cast<double>(s.response.sigma_per_s)},
      {"discriminant_per_s2", static_cast<double>(s.response.discriminant_per_s2)},
      {"initial_slope_per_s", static_cast<double>(s.response.initial_slope_per_s)},
      {"threshold_mw", static_cast<double>(s.threshold_mw)},
      {"largest_loss_mw", static_cast<double>(s.largest_loss_mw)},
      {"accumulated_mw", static_cast<double>(s.accumulated_mw)},
      {"switch_off_hz", static_cast<double>(s.switch_off_hz)},
      {"condition_rows", static_cast<double>(s.condition_rows)},
      {"condition_hits", static_cast<double>(s.condition_hits)},
      {"rocof_samples", static_cast<double>(s.rocof_samples)},
      {"event_drops", static_cast<double>(s.event_drops)},
      {"event_drop_hz", static_cast<double>(s.event_drop_hz)},
      {"event_departure_hz", static_cast<double>(s.event_departure_hz)},
      {"event_lag_s", static_cast<double>(s.event_lag_s)},
      {"t_x_sigma_s", static_cast<double>(s.t_x_sigma_s)},
      {"lse_samples", static_cast<double>(s.lse_samples)},
      {"ekf_samples", static_cast<double>(s.ekf_samples)},
      {"loss_sigma_mw", static_cast<double>(s.loss_sigma_mw)},
  };
}

}  // namespace gsbench::control_centre
