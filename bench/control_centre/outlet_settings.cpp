#include <control_centre/blocks.hpp>
#include <control_centre/outlet_settings.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>
#include <outlet/settings.hpp>

namespace gsbench::control_centre {
namespace {

// Standard deviation of the LSE per threshold loss: noise and the tracker's lag together, from runs
// with 320 … 1000 MW.
constexpr double kLseSpread = 0.25;

void set_conditions(const grid::Grid& grid, const grid::SfrModel& model,
                    gs::outlet::Settings& settings) {
  const std::vector<Condition> rows = conditions(model, grid.threshold_hz, grid.condition_row_hz);
  if (rows.size() > gs::outlet::kMaxConditions) {
    throw std::invalid_argument(
        fmt::format("condition_row_hz is {}, which gives {} load-shedding conditions; an outlet "
                    "stores at most {}: increase condition_row_hz",
                    grid.condition_row_hz, rows.size(), gs::outlet::kMaxConditions));
  }
  settings.condition_rows = static_cast<std::uint8_t>(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    settings.conditions[row] = {static_cast<float>(rows[row].from_hz),
                                static_cast<float>(rows[row].rocof_below_hz_s)};
  }
}

// Replaces the value of a field; refuses a value outside the field's range.
struct Override {
  double value;
  float nominal_hz;

  template <class T>
  void operator()(const gs::outlet::Field& field, T& member) const {
    const bool whole = std::is_floating_point_v<T> || value == std::trunc(value);
    if (!whole || !gs::outlet::within(field.range, static_cast<float>(value), nominal_hz)) {
      const double scale = field.range.of_nominal ? static_cast<double>(nominal_hz) : 1.0;
      throw std::invalid_argument(fmt::format(
          "{} is {}; it must be {} from {}{:g} to {}{:g} {}", field.name, value,
          std::is_floating_point_v<T> ? "a number" : "a whole number",
          field.range.without_least ? "above " : "", static_cast<double>(field.range.least) * scale,
          field.range.without_most ? "below " : "", static_cast<double>(field.range.most) * scale,
          field.unit));
    }
    member = static_cast<T>(value);
  }
  void rows(const gs::outlet::Field& field, gs::outlet::ConditionRow*, std::uint8_t&) const {
    throw std::invalid_argument(
        fmt::format("{} cannot be set; they are derived from the grid", field.name));
  }
};

void set(gs::outlet::Settings& settings, const std::string& name, Override value) {
  const auto& fields = gs::outlet::kSettingsFields;
  const auto* const field =
      std::find_if(std::begin(fields), std::end(fields),
                   [&](const gs::outlet::Field& one) { return one.name == name; });
  if (field == std::end(fields)) {
    throw std::invalid_argument(name + " is not a setting of an outlet");
  }
  gs::outlet::visit_field(settings, *field, value);
}

struct Description {
  std::map<std::string, double> values;

  template <class T>
  void operator()(const gs::outlet::Field& field, const T& value) {
    values[field.name] = static_cast<double>(value);
  }
  void rows(const gs::outlet::Field&, const gs::outlet::ConditionRow* rows, std::uint8_t count) {
    values["condition_rows"] = count;
    for (int row = 0; row < count; ++row) {
      const std::string name = fmt::format("condition_{:02}_", row + 1);
      values[name + "from_hz"] = static_cast<double>(rows[row].from_hz);
      values[name + "rocof_below_hz_s"] = static_cast<double>(rows[row].rocof_below_hz_s);
    }
  }
};

double switch_off_of(const grid::Grid& grid, const RequestedSettings& requested) {
  if (requested.staged_backup) {
    return Stages(grid).switch_off_hz(requested.accumulated_mw);
  }
  const double power_mw = requested.power_mw.value_or(requested.accumulated_mw);
  // The inverse of accumulated_mw().
  const double less_important_mw = requested.accumulated_mw - accumulated_mw(0.0, power_mw);
  return eq17_switch_off_hz(grid, less_important_mw, power_mw);
}

}  // namespace

gs::outlet::Settings grid_settings(const grid::Grid& grid, Rules rules) {
  const grid::SfrModel model(grid);
  gs::outlet::Settings settings;
  settings.response.gain_hz_per_mw = static_cast<float>(model.gain_hz_per_mw());
  settings.response.sigma_per_s = static_cast<float>(model.sigma_per_s());
  settings.response.discriminant_per_s2 = static_cast<float>(model.discriminant_per_s2());
  settings.response.initial_slope_per_s = static_cast<float>(model.initial_slope_per_s());
  settings.threshold_mw = static_cast<float>(threshold_mw(grid, rules));
  settings.threshold_hz = static_cast<float>(grid.threshold_hz);
  settings.largest_loss_mw = static_cast<float>(grid.base_mw);
  set_conditions(grid, model, settings);
  settings.loss_sigma_mw = static_cast<float>(
      kLseSpread * std::min(threshold_mw(model, grid.threshold_hz), grid.base_mw));
  return settings;
}

gs::outlet::Settings outlet_settings(const grid::Grid& grid, const RequestedSettings& requested,
                                     std::uint32_t version) {
  const auto nominal_hz = static_cast<float>(grid.nominal_hz);
  gs::outlet::Settings settings = grid_settings(grid, requested.rules);
  settings.version = version;
  set(settings, "accumulated_mw", {requested.accumulated_mw, nominal_hz});
  if (requested.settings.count("switch_off_hz") == 0) {
    settings.switch_off_hz = static_cast<float>(switch_off_of(grid, requested));
  }
  for (const auto& [name, value] : requested.settings) {
    set(settings, name, {value, nominal_hz});
  }
  const gs::outlet::SettingsError error = gs::outlet::validate(settings, nominal_hz);
  if (error != gs::outlet::SettingsError::kNone) {
    throw std::invalid_argument(std::string("the firmware refuses these settings: ") +
                                gs::outlet::to_string(error));
  }
  return settings;
}

double largest_accumulated_mw(const grid::Grid& grid) {
  const double least_hz = static_cast<double>(gs::outlet::kSwitchOffRange.least) * grid.nominal_hz;
  // P^A ≤ part·(load_mw − P^A/2)
  const double part = grid.damping_pu * (grid.threshold_hz - least_hz) / grid.nominal_hz;
  return std::clamp(part / (1.0 + 0.5 * part), 0.0, 2.0 / 3.0) * grid.load_mw;
}

std::map<std::string, double> described(const gs::outlet::Settings& settings) {
  Description all;
  gs::outlet::visit_fields(settings, all);
  return all.values;
}

}  // namespace gsbench::control_centre
