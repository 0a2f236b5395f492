#include "tones.hpp"

#include "sine.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::waveform {

Tones::Tones(const std::vector<Tone>& tones, std::int64_t sample_rate_hz)
    : sample_rate_hz_(static_cast<double>(sample_rate_hz)) {
  spans_.reserve(tones.size());
  for (const Tone& tone : tones) {
    const std::vector<Pulse> always = {{0.0, tone.duration_s}};
    for (const Pulse& pulse : tone.pulses.empty() ? always : tone.pulses) {
      const double to_s = std::min(pulse.to_s, tone.duration_s);
      spans_.push_back({tick_at(tone.at_s + pulse.from_s, sample_rate_hz),
                        tick_at(tone.at_s + to_s, sample_rate_hz), tone.at_s, tone.frequency_hz,
                        tone.amplitude_pct / 100.0, tone.phase_deg / 360.0});
    }
  }
}

void Tones::add(std::int64_t block_tick, std::int64_t from, std::int64_t end, float* out) const {
  std::vector<float> samples;
  for (const Span& span : spans_) {
    const std::int64_t first = std::max(from, span.from_tick);
    const std::int64_t last = std::min(end, span.end_tick);
    if (first >= last) {
      continue;
    }
    const double since_s = static_cast<double>(block_tick) / sample_rate_hz_ - span.at_s;
    Stretch stretch = {};
    stretch.base_cycles = std::remainder(since_s * span.frequency_hz, 1.0) + span.phase_cycles;
    stretch.cycles_per_sample = span.frequency_hz / sample_rate_hz_;
    stretch.amplitude = span.amplitude_pu;
    samples.resize(static_cast<std::size_t>(last - first));
    render_sine(stretch, static_cast<int>(first - block_tick), static_cast<int>(last - first),
                samples.data());
    float* const into = out + (first - from);
    std::transform(samples.begin(), samples.end(), into, into,
                   [](float tone, float voltage) { return voltage + tone; });
  }
}

}  // namespace gsbench::waveform
