#include <control_centre/threshold.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>

namespace gsbench::control_centre {

double threshold_mw(const grid::SfrModel& model, double threshold_hz) {
  if (!(threshold_hz > 0.0 && threshold_hz < model.nominal_hz())) {
    throw std::invalid_argument(
        fmt::format("threshold_hz is {}: must be above 0 and below the nominal frequency, {}",
                    threshold_hz, model.nominal_hz()));
  }
  return (model.nominal_hz() - threshold_hz) /
         (model.gain_hz_per_mw() * grid::turning_point(model).depth);
}

namespace {

// Lowest frequency after a loss at 0 of which some is shed at delay_s, to a tenth of a millihertz.
double nadir_with_shedding_hz(const grid::SfrModel& model, double loss_mw, double shed_mw,
                              double delay_s) {
  const grid::FrequencyResponse response(model, {{0.0, loss_mw}, {delay_s, -shed_mw}});
  // It falls until the shedding at least, then turns at once or later, as one loss does.
  const double last_s = delay_s + 20.0 / model.omega_n();
  double lowest_hz = response.frequency_hz(delay_s);
  constexpr double kStepS = 0.005;
  const auto steps = static_cast<int>(last_s / kStepS);
  for (int step = 0; step < steps; ++step) {
    lowest_hz = std::min(lowest_hz, response.frequency_hz(kStepS * step));
  }
  return lowest_hz;
}

}  // namespace

double threshold_for_delay_mw(const grid::SfrModel& model, double threshold_hz, double loss_mw,
                              double delay_s) {
  const double instant_mw = threshold_mw(model, threshold_hz);
  if (!(loss_mw >= 0.0 && delay_s >= 0.0)) {
    throw std::invalid_argument("loss and delay must not be negative");
  }
  if (loss_mw <= instant_mw || delay_s == 0.0) {
    return instant_mw;
  }
  if (nadir_with_shedding_hz(model, loss_mw, loss_mw, delay_s) < threshold_hz) {
    return 0.0;
  }
  double enough_mw = 0.0;  // as a threshold
  double too_high_mw = instant_mw;
  for (int i = 0; i < 50 && too_high_mw - enough_mw > 1e-4; ++i) {
    const double middle_mw = 0.5 * (enough_mw + too_high_mw);
    const bool holds =
        nadir_with_shedding_hz(model, loss_mw, loss_mw - middle_mw, delay_s) >= threshold_hz;
    (holds ? enough_mw : too_high_mw) = middle_mw;
  }
  return enough_mw;
}

double k_lse_mw_per_hz_s(const grid::SfrModel& model) {
  return 1.0 / model.unit_rocof_hz_s(0.0);
}

}  // namespace gsbench::control_centre
