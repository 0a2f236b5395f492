#include <cmath>

#include <grid/sfr_model.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

std::int64_t Plan::duration_ticks() const {
  return std::llround(stimulus.duration_s * static_cast<double>(stimulus.sample_rate_hz));
}

std::shared_ptr<const waveform::ReferenceSignal> Plan::reference() const {
  return waveform::with_oscillations(grid_reference(), stimulus.oscillations);
}

std::unique_ptr<waveform::ReferenceSignal> Plan::grid_reference() const {
  return stimulus.points.empty()
             ? waveform::reference_from_losses(grid::SfrModel(grid), stimulus.losses,
                                               stimulus.initial_deviation_hz)
             : waveform::reference_from_points(grid.nominal_hz, stimulus.points);
}

waveform::Synthesizer Plan::synthesizer() const {
  return {reference(), stimulus.signal, stimulus.sample_rate_hz};
}

}  // namespace gsbench::profile
