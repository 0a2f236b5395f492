#include "falling_limb.hpp"
#include "switch_off.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/control_centre.hpp>

namespace gsbench::grid {
namespace {

void require_threshold(const SfrModel& model, double threshold_hz) {
  if (!(threshold_hz > 0.0 && threshold_hz < model.nominal_hz())) {
    throw std::invalid_argument(
        fmt::format("threshold_hz is {}: must be above 0 and below the nominal frequency, {}",
                    threshold_hz, model.nominal_hz()));
  }
}

// From f_n down to f_s. Each edge is counted from f_n, not added up, and the last is f_s itself:
// what is left of a row by rounding alone is no row.
std::vector<double> row_edges_hz(double nominal_hz, double threshold_hz, double row_hz) {
  constexpr double kSliverOfARow = 1e-6;
  const double rows = (nominal_hz - threshold_hz) / row_hz;
  const int count = static_cast<int>(std::ceil(rows - kSliverOfARow));
  std::vector<double> edges{nominal_hz};
  for (int i = 1; i < count; ++i) edges.push_back(nominal_hz - i * row_hz);
  edges.push_back(threshold_hz);
  return edges;
}

}  // namespace

std::optional<UnderdampedParameters> underdamped_parameters(const SfrModel& model,
                                                            double reheat_s) {
  if (model.discriminant_per_s2() <= 0.0) return std::nullopt;
  const double omega_r = std::sqrt(model.discriminant_per_s2());  // eq. (8)
  const double cosine = 1.0 - model.sigma_per_s() * reheat_s;
  const double sine = omega_r * reheat_s;
  // Eq. (7): its radicand is (1 − T_R·sigma)² + (T_R·omega_r)² over 1 − zeta².
  const double alpha = std::hypot(cosine, sine) * model.omega_n() / omega_r;
  // Eq. (9): both angles lie in (0, π), where the paper's tan⁻¹ would leave the quadrant open.
  const double phi1 = std::atan2(sine, cosine);
  const double phi2 = std::atan2(omega_r, -model.sigma_per_s());
  return UnderdampedParameters{alpha, omega_r, phi1 - phi2, phi1};
}

Nadir nadir(const SfrModel& model, double loss_mw) {
  if (!(loss_mw >= 0.0)) {
    throw std::invalid_argument(fmt::format("loss_mw is {}: must be 0 or above", loss_mw));
  }
  const TurningPoint turn = turning_point(model);
  return {turn.t_s, model.nominal_hz() - loss_mw * model.gain_hz_per_mw() * turn.depth};
}

double threshold_mw(const SfrModel& model, double threshold_hz) {
  require_threshold(model, threshold_hz);
  return (model.nominal_hz() - threshold_hz) /
         (model.gain_hz_per_mw() * turning_point(model).depth);
}

namespace {

// Lowest frequency after a loss at 0 of which some is shed at delay_s, to a tenth of a millihertz.
double nadir_with_shedding_hz(const SfrModel& model, double loss_mw, double shed_mw,
                              double delay_s) {
  const FrequencyResponse response(model, {{0.0, loss_mw}, {delay_s, -shed_mw}});
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

double threshold_for_delay_mw(const SfrModel& model, double threshold_hz, double loss_mw,
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

double k_lse_mw_per_hz_s(const SfrModel& model) {
  return 1.0 / model.unit_rocof_hz_s(0.0);
}

std::vector<Condition> conditions(const SfrModel& model, double threshold_hz, double row_hz) {
  require_threshold(model, threshold_hz);
  if (!(row_hz >= kLowestConditionRowHz)) {
    throw std::invalid_argument(
        fmt::format("row_hz is {}: must be at least {}", row_hz, kLowestConditionRowHz));
  }
  const TurningPoint turn = turning_point(model);
  const double loss_mw = threshold_mw(model, threshold_hz);
  const std::vector<double> edges = row_edges_hz(model.nominal_hz(), threshold_hz, row_hz);
  std::vector<Condition> rows;
  for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
    const double depth = (model.nominal_hz() - edges[i]) / (loss_mw * model.gain_hz_per_mw());
    const double t_s = time_at_depth_s(model, turn, depth);
    rows.push_back({edges[i], edges[i - 1], loss_mw * model.unit_rocof_hz_s(t_s)});
  }
  // The threshold loss turns at f_s, or comes to rest there: its ROCOF is 0 by definition of ΔP_s.
  rows.push_back({threshold_hz, edges[edges.size() - 2], 0.0});
  return rows;
}

std::vector<BlockSetting> block_settings(const Grid& grid) {
  check(grid);
  std::vector<BlockSetting> settings;
  double less_important_mw = 0.0;
  for (const Block& block : grid.blocks) {
    const double accumulated_mw = less_important_mw + block.power_mw;
    settings.push_back({block.id, block.power_mw, accumulated_mw,
                        block_switch_off_hz(grid, less_important_mw, block.power_mw)});
    less_important_mw = accumulated_mw;
  }
  return settings;
}

double switch_off_hz(const Grid& grid, double accumulated_mw, double power_mw) {
  if (!(power_mw >= 0.0 && power_mw <= accumulated_mw && accumulated_mw <= grid.load_mw)) {
    throw std::invalid_argument(fmt::format(
        "power_mw is {} and accumulated_mw {}: must be 0 <= power_mw <= accumulated_mw <= load_mw, "
        "{}",
        power_mw, accumulated_mw, grid.load_mw));
  }
  const double switch_off = block_switch_off_hz(grid, accumulated_mw - power_mw, power_mw);
  if (!(switch_off > 0.0)) {
    throw std::invalid_argument(
        fmt::format("power_mw is {} with damping_pu {}: its switching-off frequency, eq. (17), "
                    "would be {} Hz and must be above 0",
                    power_mw, grid.damping_pu, switch_off));
  }
  return switch_off;
}

}  // namespace gsbench::grid
