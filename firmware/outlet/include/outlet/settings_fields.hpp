// The fields of Settings in their one order: what digests, validates, encodes or decodes them
// visits them by this list, so that none can forget a field that another knows.
#pragma once

#include <outlet/settings.hpp>

namespace gs::outlet {

// `S` is Settings or const Settings. Calls visit(field) for each field, and visit.count(rows, most)
// for the number of condition rows, before the rows themselves.
template <class S, class Visitor>
void visit_fields(S& s, Visitor& visit) {
  visit(s.version);
  visit(s.response.gain_hz_per_mw);
  visit(s.response.sigma_per_s);
  visit(s.response.discriminant_per_s2);
  visit(s.response.initial_slope_per_s);
  visit(s.threshold_mw);
  visit(s.largest_loss_mw);
  visit(s.accumulated_mw);
  visit(s.switch_off_hz);
  visit.count(s.condition_rows, kMaxConditions);
  for (int row = 0; row < s.condition_rows && row < kMaxConditions; ++row) {
    visit(s.conditions[row].from_hz);
    visit(s.conditions[row].rocof_below_hz_s);
  }
  visit(s.condition_hits);
  visit(s.rocof_samples);
  visit(s.event_drops);
  visit(s.event_drop_hz);
  visit(s.event_departure_hz);
  visit(s.lse_samples);
  visit(s.ekf_samples);
  visit(s.measurement_sigma_hz);
  visit(s.loss_sigma_mw);
  visit(s.event_lag_s);
  visit(s.t_x_sigma_s);
  visit(s.trusted_residual_hz);
  visit(s.switch_off_samples);
  visit(s.tracker.phase_noise_rad);
  visit(s.tracker.jerk_rad_s3_per_sqrt_hz);
  visit(s.tracker.leap_rad);
  visit(s.tracker.leap_amplitude);
  visit(s.tracker.dead_bus_pu);
}

}  // namespace gs::outlet
