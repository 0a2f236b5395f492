#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>

namespace gsbench::control_centre {

double threshold_mw(const grid::SfrModel& model, double threshold_hz) {
  if (!(threshold_hz > 0.0 && threshold_hz < model.nominal_hz())) {
    throw std::invalid_argument(
        fmt::format("threshold_hz is {}; it must be above 0 and below {} (nominal frequency)",
                    threshold_hz, model.nominal_hz()));
  }
  return (model.nominal_hz() - threshold_hz) /
         (model.gain_hz_per_mw() * grid::unit_nadir(model).depth);
}

namespace {

// Lowest frequency after a loss at t = 0 with shed_mw <= loss_mw shed at delay_s.
double nadir_with_shedding_hz(const grid::SfrModel& model, double loss_mw, double shed_mw,
                              double delay_s) {
  const grid::Nadir without = grid::nadir(model, loss_mw);
  if (without.t_s <= delay_s) {
    return without.frequency_hz;
  }
  // The frequency falls at least until delay_s, and turns then or later. A later minimum is higher.
  const grid::FrequencyResponse response(model, {{0.0, loss_mw}, {delay_s, -shed_mw}});
  const double last_s = delay_s + 20.0 / model.omega_n();
  const double step_s = 0.02 / model.omega_n();
  double falling_s = delay_s;
  while (falling_s < last_s && response.rocof_hz_s(falling_s + step_s) < 0.0) {
    falling_s += step_s;
  }
  double rising_s = falling_s + step_s;
  for (int i = 0; i < 20; ++i) {
    const double middle_s = 0.5 * (falling_s + rising_s);
    (response.rocof_hz_s(middle_s) < 0.0 ? falling_s : rising_s) = middle_s;
  }
  return std::min(response.frequency_hz(delay_s), response.frequency_hz(falling_s));
}

// Edges from f_n down to f_s. Each is computed from f_n, so that rounding errors do not add up. The
// last is f_s itself; a remainder due to rounding does not make a row.
std::vector<double> row_edges_hz(double nominal_hz, double threshold_hz, double row_hz) {
  constexpr double kSliverOfARow = 1e-6;
  const double rows = (nominal_hz - threshold_hz) / row_hz;
  const int count = static_cast<int>(std::ceil(rows - kSliverOfARow));
  std::vector<double> edges{nominal_hz};
  for (int i = 1; i < count; ++i) {
    edges.push_back(nominal_hz - i * row_hz);
  }
  edges.push_back(threshold_hz);
  return edges;
}

}  // namespace

double threshold_for_delay_mw(const grid::SfrModel& model, double threshold_hz, double loss_mw,
                              double delay_s) {
  const double instant_mw = threshold_mw(model, threshold_hz);
  if (!(loss_mw >= 0.0 && delay_s >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("loss_mw is {} and delay_s {}; both must be at least 0", loss_mw, delay_s));
  }
  if (loss_mw <= instant_mw || delay_s == 0.0) {
    return instant_mw;
  }
  if (nadir_with_shedding_hz(model, loss_mw, loss_mw, delay_s) < threshold_hz) {
    return 0.0;
  }
  double enough_mw = 0.0;  // a threshold loss that keeps the nadir at threshold_hz
  double too_high_mw = instant_mw;
  for (int i = 0; i < 50 && too_high_mw - enough_mw > 1e-4; ++i) {
    const double middle_mw = 0.5 * (enough_mw + too_high_mw);
    const bool holds =
        nadir_with_shedding_hz(model, loss_mw, loss_mw - middle_mw, delay_s) >= threshold_hz;
    (holds ? enough_mw : too_high_mw) = middle_mw;
  }
  return enough_mw;
}

double credible_loss_mw(const grid::Grid& grid) {
  return grid.credible_loss_mw.value_or(kCredibleLossFactor *
                                        threshold_mw(grid::SfrModel(grid), grid.threshold_hz));
}

double delay_aware_threshold_mw(const grid::Grid& grid) {
  constexpr double kBelowTheBest_hz = 0.010;
  const grid::SfrModel model(grid);
  const double instant_mw = threshold_mw(model, grid.threshold_hz);
  const double loss_mw = credible_loss_mw(grid);
  const double best_hz = nadir_with_shedding_hz(model, loss_mw, loss_mw, kOutletDelay_s);
  const double lowest_hz = std::min(grid.threshold_hz, best_hz - kBelowTheBest_hz);
  if (lowest_hz <= 0.0) {
    return instant_mw;  // the model's grid has collapsed before outlets act
  }
  return std::min(instant_mw, threshold_for_delay_mw(model, lowest_hz, loss_mw, kOutletDelay_s));
}

double threshold_mw(const grid::Grid& grid, Rules rules) {
  return rules == Rules::kPaper ? threshold_mw(grid::SfrModel(grid), grid.threshold_hz)
                                : delay_aware_threshold_mw(grid);
}

double k_lse_mw_per_hz_s(const grid::SfrModel& model) {
  return 1.0 / model.unit_rocof_hz_s(0.0);
}

std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz) {
  const double loss_mw = threshold_mw(model, threshold_hz);
  if (!(row_hz >= grid::kLowestConditionRow_hz)) {
    throw std::invalid_argument(
        fmt::format("row_hz is {}; it must be at least {}", row_hz, grid::kLowestConditionRow_hz));
  }
  const grid::UnitNadir lowest = grid::unit_nadir(model);
  const std::vector<double> edges = row_edges_hz(model.nominal_hz(), threshold_hz, row_hz);
  std::vector<Condition> rows;
  for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
    const double depth = (model.nominal_hz() - edges[i]) / (loss_mw * model.gain_hz_per_mw());
    const double t_s = grid::time_at_depth_s(model, lowest, depth);
    rows.push_back({edges[i], edges[i - 1], loss_mw * model.unit_rocof_hz_s(t_s)});
  }
  // After the threshold loss the frequency turns or settles at f_s: ROCOF is 0 there.
  rows.push_back({threshold_hz, edges[edges.size() - 2], 0.0});
  return rows;
}

}  // namespace gsbench::control_centre
