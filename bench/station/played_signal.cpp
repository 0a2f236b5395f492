#include "played_signal.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::station {
namespace {

using waveform::AmplitudeStep;

// Dips of 170 ms by their beginnings. No spacing occurs twice in a row, so that a dip that is
// missed or another one's is told. The last is far enough from the run for a tracker to be calm
// again.
constexpr double kDipS = 0.170;
constexpr double kBeforeS[] = {0.500, 0.900, 1.460};
constexpr double kLeadS = 2.800;
constexpr double kAfterS[] = {0.400, 0.960, 1.360};
constexpr double kTailS = 2.000;

waveform::Synthesizer calm(double frequency_hz, double phase_deg, const double (&dips_s)[3],
                           double level, std::int64_t sample_rate_hz) {
  waveform::SignalSpec spec;
  spec.initial_phase_deg = phase_deg;
  for (const double at_s : dips_s) {
    spec.amplitude_steps.push_back({at_s, kDipS, 100.0 * level});
  }
  return {waveform::truth_from_points(frequency_hz, {{0.0, frequency_hz}}), spec, sample_rate_hz};
}

}  // namespace

PlayedSignal::PlayedSignal(const profile::Plan& plan, bool with_markers)
    : run_ticks_(plan.duration_ticks()) {
  const std::int64_t rate = plan.stimulus.sample_rate_hz;
  const auto ticks = [&](double t_s) {
    return static_cast<std::int64_t>(std::llround(t_s * static_cast<double>(rate)));
  };
  const double first_hz = plan.truth()->frequency_hz(0.0);
  if (with_markers) {
    lead_ticks_ = ticks(kLeadS);
    tail_ticks_ = ticks(kTailS);
    // In phase with the run's first sample, and at its frequency: nothing happens at tick 0.
    const double cycles = first_hz * kLeadS;
    const double phase_deg =
        plan.stimulus.signal.initial_phase_deg - 360.0 * (cycles - std::floor(cycles));
    parts_.push_back({0, calm(first_hz, phase_deg, kBeforeS, markers_.level, rate)});
    for (const double at_s : kBeforeS) {
      markers_.before.push_back({ticks(at_s) - lead_ticks_, ticks(at_s + kDipS) - lead_ticks_});
    }
  }
  parts_.push_back({lead_ticks_, plan.synthesizer()});
  if (with_markers) {
    parts_.push_back(
        {lead_ticks_ + run_ticks_, calm(plan.grid.nominal_hz, 0.0, kAfterS, markers_.level, rate)});
    for (const double at_s : kAfterS) {
      markers_.after.push_back({run_ticks_ + ticks(at_s), run_ticks_ + ticks(at_s + kDipS)});
    }
  }
}

void PlayedSignal::render(std::int64_t first_tick, std::size_t count, float* out) const {
  const std::int64_t end_tick = first_tick + static_cast<std::int64_t>(count);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::int64_t part_end = i + 1 < parts_.size() ? parts_[i + 1].first_tick : total_ticks();
    const std::int64_t from = std::max(first_tick, parts_[i].first_tick);
    const std::int64_t to = std::min(end_tick, part_end);
    if (from < to) {
      parts_[i].synthesizer.render(from - parts_[i].first_tick, static_cast<std::size_t>(to - from),
                                   out + (from - first_tick));
    }
  }
}

}  // namespace gsbench::station
