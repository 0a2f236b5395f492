#include "balance.hpp"

#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gsbench::fleet {
namespace {

constexpr double kResultStep_s = 0.02;

}  // namespace

void Balance::shed(double at_s, double power_mw) {
  if (power_mw > 0.0) {
    response_.change(at_s, -power_mw);
    first_s_ = std::fmin(first_s_, at_s);
    last_s_ = std::fmax(last_s_, at_s);
    shed_mw_ += power_mw;
  }
}

ScenarioResult Balance::result(const grid::Grid& grid, double duration_s, Shed shed) const {
  ScenarioResult result;
  result.shed = std::move(shed);
  result.shed.power_mw = shed_mw_;
  result.threshold_mw = control_centre::threshold_mw(response_.model(), grid.threshold_hz);
  result.required_mw = std::max(loss_mw_ - result.threshold_mw, 0.0);
  result.first_action_s = first_s_;
  result.last_action_s = last_s_;
  double lowest_hz = 0.0;
  const auto steps = static_cast<std::size_t>(duration_s / kStep_s);
  const auto each = static_cast<std::size_t>(std::llround(kResultStep_s / kStep_s));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t_s = kStep_s * static_cast<double>(i);
    const double now_hz = deviation_hz(t_s);
    if (now_hz < lowest_hz) {
      lowest_hz = now_hz;
      result.nadir_s = t_s;
    }
    if (i % each == 0) {
      result.t_s.push_back(t_s);
      result.frequency_hz.push_back(grid.nominal_hz + now_hz);
    }
  }
  result.nadir_hz = grid.nominal_hz + lowest_hz;
  result.end_hz = result.frequency_hz.back();
  return result;
}

}  // namespace gsbench::fleet
