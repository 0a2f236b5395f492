#include "partials.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gsbench::waveform {

bool is_of_series(const Harmonic& harmonic) {
  return harmonic.order >= 2.0 && harmonic.order <= kHighestOfSeries &&
         harmonic.order == std::floor(harmonic.order);
}

Partials::Partials(const std::vector<Harmonic>& harmonics, double nominal_hz,
                   std::int64_t sample_rate_hz) {
  for (const Harmonic& harmonic : harmonics) {
    if (!is_of_series(harmonic)) {
      partials_.push_back({harmonic.order,
                           NominalPhase(harmonic.order * nominal_hz, sample_rate_hz),
                           harmonic.amplitude_pct / 100.0, harmonic.phase_deg / 360.0});
    }
  }
}

// The phase of order k is k times that of the fundamental, counted through all cycles since the
// start; whole cycles of the product are dropped term by term.
void Partials::add(std::int64_t block_tick, const SmoothPiece& piece, const ScheduleEntry& signal,
                   const Stretch& fundamental, int first, int count, float* out) const {
  constexpr int kBatch = 256;
  std::array<float, kBatch> samples;
  for (const Partial& partial : partials_) {
    const double order = partial.order;
    Stretch stretch = fundamental;
    stretch.base_cycles = partial.nominal_phase.cycles_at(block_tick) +
                          std::remainder(order * piece.excess_at_start, 1.0) +
                          std::remainder(order * signal.turns, 1.0) + partial.phase_cycles;
    stretch.cycles_per_sample *= order;
    for (double& coefficient : stretch.cycles) {
      coefficient *= order;
    }
    stretch.amplitude *= partial.amplitude_pu;
    stretch.amplitude_slope *= partial.amplitude_pu;
    stretch.offset = 0.0;
    for (int done = 0; done < count; done += kBatch) {
      const int batch = std::min(kBatch, count - done);
      render_sine(stretch, first + done, batch, samples.data());
      std::transform(samples.begin(), samples.begin() + batch, out + done, out + done,
                     [](float partial_pu, float voltage) { return voltage + partial_pu; });
    }
  }
}

}  // namespace gsbench::waveform
