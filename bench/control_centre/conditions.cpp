#include <control_centre/conditions.hpp>
#include <control_centre/threshold.hpp>

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>

namespace gsbench::control_centre {
namespace {

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

std::vector<Condition> conditions(const grid::SfrModel& model, double threshold_hz, double row_hz) {
  const double loss_mw = threshold_mw(model, threshold_hz);
  if (!(row_hz >= grid::kLowestConditionRowHz)) {
    throw std::invalid_argument(
        fmt::format("row_hz is {}: must be at least {}", row_hz, grid::kLowestConditionRowHz));
  }
  const grid::TurningPoint turn = grid::turning_point(model);
  const std::vector<double> edges = row_edges_hz(model.nominal_hz(), threshold_hz, row_hz);
  std::vector<Condition> rows;
  for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
    const double depth = (model.nominal_hz() - edges[i]) / (loss_mw * model.gain_hz_per_mw());
    const double t_s = grid::time_at_depth_s(model, turn, depth);
    rows.push_back({edges[i], edges[i - 1], loss_mw * model.unit_rocof_hz_s(t_s)});
  }
  // The threshold loss turns at f_s, or comes to rest there: its ROCOF is 0 by definition of ΔP_s.
  rows.push_back({threshold_hz, edges[edges.size() - 2], 0.0});
  return rows;
}

}  // namespace gsbench::control_centre
