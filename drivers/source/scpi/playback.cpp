#include "playback.hpp"

#include "codes.hpp"

#include <algorithm>
#include <cmath>

#include <source/chord.hpp>
#include <source/deviation.hpp>

namespace gsbench::scpi {
namespace {

constexpr double kJustAfter = 1e-9;

}  // namespace

double Playback::level(std::size_t point) const {
  return full_scale_pu_ * level_of(codes_[std::min(point, codes_.size() - 1)], instrument_);
}

double Playback::at(double position) const {
  const auto point = static_cast<std::size_t>(position);
  if (instrument_.rate.interpolation == Interpolation::kHold) {
    return level(point);
  }
  const double part = position - static_cast<double>(point);
  return (1.0 - part) * level(point) + part * level(point + 1);
}

double Playback::mean(double from, double to) const {
  double sum = 0.0;
  for (double begin = from; begin < to;) {
    const double end = std::min(to, std::floor(begin + kJustAfter) + 1.0);
    // Exact for held points and for straight lines.
    sum += (end - begin) * at(0.5 * (begin + end));
    begin = end;
  }
  return sum / (to - from);
}

double Playback::point_error(const std::vector<float>& points) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    largest = std::max(largest, std::fabs(level(i) - static_cast<double>(points[i])));
  }
  return largest;
}

source::Played Playback::deviation(const source::Stimulus& stimulus, const LoadedWaveform& ideal,
                                   const std::vector<float>& points) const {
  const double points_per_tick = rate_hz_ / static_cast<double>(stimulus.sample_rate_hz());
  const auto ticks = static_cast<std::size_t>(stimulus.total_ticks());
  const float* const wanted = ideal.voltage_pu.data() + ideal.lead_ticks;
  std::vector<float> means(ticks);
  source::Played largest;
  for (std::size_t n = 0; n < ticks; ++n) {
    const double position =
        static_cast<double>(ideal.lead_ticks + static_cast<std::int64_t>(n)) * points_per_tick;
    means[n] = static_cast<float>(
        mean(position - 0.5 * points_per_tick, position + 0.5 * points_per_tick));
    largest.voltage_pu = std::max(
        largest.voltage_pu, std::fabs(at(position + kJustAfter) - static_cast<double>(wanted[n])));
  }
  source::DeviationMeter meter(stimulus.sample_rate_hz(), stimulus.nominal_hz());
  meter.add(wanted, means.data(), ticks);
  largest.frequency_hz = meter.largest().frequency_hz;
  // Points between ticks have errors too.
  largest.voltage_pu = std::max(largest.voltage_pu, point_error(points));
  if (instrument_.rate.interpolation == Interpolation::kLinear) {
    source::ChordMeter chord(std::llround(rate_hz_ / stimulus.nominal_hz()));
    chord.add(points.data(), points.size());
    largest.voltage_pu += chord.largest();
  }
  return largest;
}

}  // namespace gsbench::scpi
