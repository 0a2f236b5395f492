// Settings of an outlet in the modified IEEE 24-bus system of Xiang et al., and that system.
#pragma once

#include <control_centre/threshold.hpp>

#include <memory>

#include <grid/sfr_model.hpp>
#include <outlet/settings.hpp>
#include <waveform/reference_signal.hpp>

namespace gs::test {

// Reduced to one plant, calibrated to the paper's threshold of 351.9 MW.
inline gsbench::grid::Grid ieee24() {
  gsbench::grid::Grid grid;
  grid.base_mw = 2745.0;
  grid.load_mw = 2745.0;
  grid.damping_pu = 2.5;
  grid.plants = {{"all", 2745.0, 9.2161, 1.0 / 21.8601}};
  return grid;
}

inline outlet::Response response_of(const gsbench::grid::SfrModel& model) {
  outlet::Response response;
  response.gain_hz_per_mw = static_cast<float>(model.gain_hz_per_mw());
  response.sigma_per_s = static_cast<float>(model.sigma_per_s());
  response.discriminant_per_s2 = static_cast<float>(model.discriminant_per_s2());
  response.initial_slope_per_s = static_cast<float>(model.initial_slope_per_s());
  return response;
}

// An outlet that sheds at a loss of 351.9 + 100 MW or more, and switches off below 49.0 Hz.
inline outlet::Settings ieee24_settings() {
  const gsbench::grid::Grid grid = ieee24();
  const gsbench::grid::SfrModel model(grid);
  outlet::Settings settings;
  settings.version = 1;
  settings.response = response_of(model);
  settings.threshold_hz = static_cast<float>(grid.threshold_hz);
  settings.threshold_mw =
      static_cast<float>(gsbench::control_centre::threshold_mw(model, grid.threshold_hz));
  settings.largest_loss_mw = static_cast<float>(grid.base_mw);
  settings.accumulated_mw = 100.0F;
  settings.switch_off_hz = 49.0F;
  settings.loss_sigma_mw = 0.25F * settings.threshold_mw;
  for (const gsbench::control_centre::Condition& row :
       gsbench::control_centre::conditions(model, grid.threshold_hz, grid.condition_row_hz)) {
    settings.conditions[settings.condition_rows] = {static_cast<float>(row.from_hz),
                                                    static_cast<float>(row.rocof_below_hz_s)};
    ++settings.condition_rows;
  }
  return settings;
}

inline std::shared_ptr<const gsbench::waveform::ReferenceSignal> loss_of(double power_mw,
                                                                         double at_s) {
  return gsbench::waveform::reference_from_losses(gsbench::grid::SfrModel(ieee24()),
                                                  {{at_s, power_mw}});
}

}  // namespace gs::test
