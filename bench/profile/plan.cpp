#include <cmath>

#include <grid/sfr_model.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

std::int64_t Plan::duration_ticks() const {
  return std::llround(stimulus.duration_s * static_cast<double>(stimulus.sample_rate_hz));
}

std::shared_ptr<const waveform::Truth> Plan::truth() const {
  return stimulus.points.empty()
             ? waveform::truth_from_losses(grid::SfrModel(grid), stimulus.losses)
             : waveform::truth_from_points(grid.nominal_hz, stimulus.points);
}

waveform::Synthesizer Plan::synthesizer() const {
  return {truth(), stimulus.signal, stimulus.sample_rate_hz};
}

}  // namespace gsbench::profile
