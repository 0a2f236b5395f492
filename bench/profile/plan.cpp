#include <cmath>
#include <stdexcept>

#include <grid/sfr_model.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

std::int64_t Plan::duration_ticks() const {
  return std::llround(stimulus.duration_s * static_cast<double>(stimulus.sample_rate_hz));
}

std::shared_ptr<const waveform::Truth> Plan::truth() const {
  switch (stimulus.kind) {
    case TruthKind::kLosses:
      return waveform::truth_from_losses(grid::SfrModel(grid), stimulus.losses);
    case TruthKind::kPoints:
    case TruthKind::kTrace:
      return waveform::truth_from_points(grid.nominal_hz, stimulus.points);
  }
  throw std::logic_error("unknown kind of truth");
}

waveform::Synthesizer Plan::synthesizer() const {
  return {truth(), stimulus.signal, stimulus.sample_rate_hz};
}

}  // namespace gsbench::profile
