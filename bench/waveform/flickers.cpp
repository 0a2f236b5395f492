#include "flickers.hpp"

#include "sine.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::waveform {
namespace {

// Times closer than this are equal, as those of steps.
constexpr double kSameInstant_s = 1e-9;

// Of the shape, −1 … 1.
double wave(const Flicker& flicker, double since_s) {
  if (flicker.rectangular) {
    const double halves = std::floor(2.0 * flicker.frequency_hz * (since_s + kSameInstant_s));
    return std::fmod(halves, 2.0) == 0.0 ? 1.0 : -1.0;
  }
  return sine_of(flicker.frequency_hz * since_s);
}

}  // namespace

Flickers::Flickers(const std::vector<Flicker>& flickers, std::int64_t sample_rate_hz)
    : sample_rate_hz_(static_cast<double>(sample_rate_hz)) {
  spans_.reserve(flickers.size());
  for (const Flicker& flicker : flickers) {
    spans_.push_back({tick_at(flicker.at_s, sample_rate_hz),
                      tick_at(flicker.at_s + flicker.duration_s, sample_rate_hz), flicker});
  }
}

bool Flickers::is_on(std::int64_t from, std::int64_t end) const {
  return std::any_of(spans_.begin(), spans_.end(), [&](const Span& span) {
    return span.from_tick < end && from < span.end_tick;
  });
}

double Flickers::factor(std::int64_t tick) const {
  double factor = 1.0;
  for (const Span& span : spans_) {
    if (span.from_tick <= tick && tick < span.end_tick) {
      const double since_s = static_cast<double>(tick) / sample_rate_hz_ - span.flicker.at_s;
      factor *= 1.0 + 0.5 * span.flicker.depth_pct / 100.0 * wave(span.flicker, since_s);
    }
  }
  return factor;
}

void Flickers::modulate(std::int64_t from, std::int64_t end, float offset, float* samples) const {
  for (std::int64_t tick = from; tick < end; ++tick, ++samples) {
    const double now = factor(tick);
    if (now != 1.0) {  // the sum below rounds
      *samples = static_cast<float>(now) * (*samples - offset) + offset;
    }
  }
}

}  // namespace gsbench::waveform
