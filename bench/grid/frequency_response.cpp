#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {

FrequencyResponse::FrequencyResponse(SfrModel model, std::vector<PowerChange> changes)
    : model_(std::move(model)), changes_(std::move(changes)) {
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (!std::isfinite(changes_[i].at_s) || !std::isfinite(changes_[i].power_mw)) {
      throw std::invalid_argument(fmt::format("power change {}: {} MW at {} s: both must be finite",
                                              i + 1, changes_[i].power_mw, changes_[i].at_s));
    }
  }
}

double FrequencyResponse::frequency_hz(double t_s) const {
  double deviation_hz = 0.0;
  for (const PowerChange& change : changes_) {
    deviation_hz += change.power_mw * model_.unit_deviation_hz(t_s - change.at_s);
  }
  return model_.nominal_hz() + deviation_hz;
}

double FrequencyResponse::rocof_hz_s(double t_s) const {
  double sum_hz_s = 0.0;
  for (const PowerChange& change : changes_) {
    sum_hz_s += change.power_mw * model_.unit_rocof_hz_s(t_s - change.at_s);
  }
  return sum_hz_s;
}

double FrequencyResponse::excess_cycles(double t_s) const {
  double sum_cycles = 0.0;
  for (const PowerChange& change : changes_) {
    sum_cycles += change.power_mw * model_.unit_phase_cycles(t_s - change.at_s);
  }
  return sum_cycles;
}

}  // namespace gsbench::grid
