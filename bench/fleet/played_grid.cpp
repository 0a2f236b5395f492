#include "played_grid.hpp"

#include <algorithm>
#include <utility>

#include <fleet/clairvoyant.hpp>

namespace gsbench::fleet {
namespace {

using waveform::ReferenceSignal;

// The profile's reference plus the response to load switched off so far. The synthesizer reads the
// corners once, so those of the switched load are given for the samples to be rendered.
class FedBackReference final : public ReferenceSignal {
 public:
  FedBackReference(std::shared_ptr<const ReferenceSignal> played,
                   std::shared_ptr<const GridResponse> shed, std::vector<double> corners_s)
      : played_(std::move(played)), shed_(std::move(shed)), corners_s_(std::move(corners_s)) {}

  double nominal_hz() const override { return played_->nominal_hz(); }
  double frequency_hz(double t_s) const override {
    return played_->frequency_hz(t_s) + shed_->at(t_s).deviation_hz;
  }
  double rocof_hz_s(double t_s) const override {
    return played_->rocof_hz_s(t_s) + shed_->at(t_s).slope_hz_s;
  }
  double excess_cycles(double t_s) const override {
    return played_->excess_cycles(t_s) + shed_->at(t_s).cycles;
  }
  double voltage_pu(double t_s) const override { return played_->voltage_pu(t_s); }
  std::vector<double> corners_s() const override { return corners_s_; }

 private:
  std::shared_ptr<const ReferenceSignal> played_;
  std::shared_ptr<const GridResponse> shed_;
  std::vector<double> corners_s_;
};

}  // namespace

PlayedGrid::PlayedGrid(const profile::Plan& plan)
    : plan_(plan),
      of_model_(plan.grid_reference()),
      played_(plan.reference()),
      shed_(std::make_shared<GridResponse>(grid::SfrModel(plan.grid))),
      corners_s_(played_->corners_s()),
      synthesizer_(std::make_shared<FedBackReference>(played_, shed_, corners_s_),
                   plan.stimulus.signal, plan.stimulus.sample_rate_hz) {}

void PlayedGrid::switch_off(double at_s, double power_mw) {
  shed_->change(at_s, -power_mw);
}

GridState PlayedGrid::state(double t_s) const {
  GridState state = shed_->at(t_s);
  state.deviation_hz += of_model_->frequency_hz(t_s) - of_model_->nominal_hz();
  state.slope_hz_s += of_model_->rocof_hz_s(t_s);
  state.power_mw += lost_mw(losses(), t_s);
  state.cycles += of_model_->excess_cycles(t_s);
  return state;
}

void PlayedGrid::render(std::int64_t first_tick, std::size_t count, float* out) const {
  const auto rate_hz = static_cast<double>(synthesizer_.sample_rate_hz());
  const std::int64_t block = synthesizer_.sample_rate_hz() / 1000 * 16;  // as the synthesizer's
  const auto end_tick = first_tick + static_cast<std::int64_t>(count);
  const double from_s = static_cast<double>(first_tick - first_tick % block - 1) / rate_hz;
  const double end_s = static_cast<double>(end_tick + block) / rate_hz;
  std::vector<double> corners_s = shed_->changes_s(from_s, end_s);
  if (corners_s.empty()) {
    synthesizer_.render(first_tick, count, out);
    return;
  }
  corners_s.insert(corners_s.end(), std::lower_bound(corners_s_.begin(), corners_s_.end(), from_s),
                   std::lower_bound(corners_s_.begin(), corners_s_.end(), end_s));
  std::sort(corners_s.begin(), corners_s.end());
  const waveform::Synthesizer with_corners(
      std::make_shared<FedBackReference>(played_, shed_, std::move(corners_s)),
      plan_.stimulus.signal, plan_.stimulus.sample_rate_hz);
  with_corners.render(first_tick, count, out);
}

}  // namespace gsbench::fleet
