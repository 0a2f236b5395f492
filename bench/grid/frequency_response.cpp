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

double FrequencyResponse::sum(double (SfrModel::*of_one_mw)(double t_s) const, double t_s) const {
  double sum = 0.0;
  for (const PowerChange& change : changes_) {
    sum += change.power_mw * (model_.*of_one_mw)(t_s - change.at_s);
  }
  return sum;
}

}  // namespace gsbench::grid
