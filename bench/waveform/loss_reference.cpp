#include <algorithm>
#include <utility>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {
namespace {

class LossReference final : public ReferenceSignal {
 public:
  LossReference(grid::SfrModel model, std::vector<grid::PowerChange> losses,
                double initial_deviation_hz)
      : response_(std::move(model), std::move(losses), initial_deviation_hz),
        cycles_at_zero_(response_.excess_cycles(0.0)) {}

  double nominal_hz() const override { return response_.model().nominal_hz(); }
  double frequency_hz(double t_s) const override { return response_.frequency_hz(t_s); }
  double rocof_hz_s(double t_s) const override { return response_.rocof_hz_s(t_s); }
  double excess_cycles(double t_s) const override {
    return response_.excess_cycles(t_s) - cycles_at_zero_;
  }
  double voltage_pu(double /*t_s*/) const override { return 1.0; }

  std::vector<double> corners_s() const override {
    std::vector<double> corners;
    for (const grid::PowerChange& change : response_.changes()) {
      corners.push_back(change.at_s);
      if (change.ramp_s > 0.0) {
        corners.push_back(change.at_s + change.ramp_s);
      }
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  }

 private:
  grid::FrequencyResponse response_;
  double cycles_at_zero_;
};

}  // namespace

std::unique_ptr<ReferenceSignal> reference_from_losses(grid::SfrModel model,
                                                       std::vector<grid::PowerChange> losses,
                                                       double initial_deviation_hz) {
  return std::make_unique<LossReference>(std::move(model), std::move(losses), initial_deviation_hz);
}

}  // namespace gsbench::waveform
