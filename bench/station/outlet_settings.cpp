#include <limits>
#include <stdexcept>

#include <grid/control_centre.hpp>
#include <profile/load.hpp>
#include <settings/grid_settings.hpp>
#include <station/outlet_settings.hpp>

namespace gsbench::station {
namespace {

using gs::outlet::Settings;

template <class Count>
void set_count(const std::optional<int>& wanted, const char* what, const profile::Plan& plan,
               Count& field) {
  if (!wanted) {
    return;
  }
  if (*wanted < 0 || *wanted > std::numeric_limits<Count>::max()) {
    throw profile::ConfigurationError(plan.path + ": " + what + " = " + std::to_string(*wanted) +
                                      " is out of the firmware's range");
  }
  field = static_cast<Count>(*wanted);
}

Settings settings_of(const profile::Plan& plan) {
  try {
    return settings::grid_settings(plan.grid);
  } catch (const std::invalid_argument& error) {
    throw profile::ConfigurationError(plan.path + ": " + error.what());
  }
}

double switch_off_hz(const profile::Plan& plan, const profile::OutletSettings& outlet) {
  if (outlet.switch_off_hz) {
    return *outlet.switch_off_hz;
  }
  const double power_mw = outlet.power_mw.value_or(outlet.accumulated_mw);
  if (!(power_mw > 0.0)) {
    return plan.grid.threshold_hz;
  }
  return grid::switch_off_hz(plan.grid, outlet.accumulated_mw, power_mw);
}

}  // namespace

Settings outlet_settings(const profile::Plan& plan, const profile::Outlet& outlet,
                         std::uint32_t version) {
  const profile::OutletSettings& wanted = outlet.settings;
  Settings settings = settings_of(plan);
  settings.version = version;
  if (wanted.threshold_mw) {
    settings.threshold_mw = static_cast<float>(*wanted.threshold_mw);
  }
  settings.accumulated_mw = static_cast<float>(wanted.accumulated_mw);
  settings.switch_off_hz = static_cast<float>(switch_off_hz(plan, wanted));
  if (wanted.event_drop_hz) {
    settings.event_drop_hz = static_cast<float>(*wanted.event_drop_hz);
  }
  if (wanted.event_departure_hz) {
    settings.event_departure_hz = static_cast<float>(*wanted.event_departure_hz);
  }
  set_count(wanted.condition_hits, "condition_hits", plan, settings.condition_hits);
  set_count(wanted.lse_samples, "lse_samples", plan, settings.lse_samples);
  set_count(wanted.ekf_samples, "ekf_samples", plan, settings.ekf_samples);

  const gs::outlet::SettingsError error =
      gs::outlet::validate(settings, static_cast<float>(plan.grid.nominal_hz));
  if (error != gs::outlet::SettingsError::kNone) {
    throw profile::ConfigurationError(
        plan.path + ": outlet " + outlet.id +
        ": the firmware refuses these settings: " + gs::outlet::to_string(error));
  }
  return settings;
}

std::map<std::string, double> described(const Settings& s) {
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

}  // namespace gsbench::station
