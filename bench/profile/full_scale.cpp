#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::Table;

// Product of the amplitude steps that are active at t_s; with `before`, just before t_s.
double step_level(const std::vector<waveform::AmplitudeStep>& steps, double t_s, bool before) {
  double level = 1.0;
  for (const waveform::AmplitudeStep& step : steps) {
    const double end_s = step.at_s + step.duration_s;
    const bool on = before ? step.at_s < t_s && t_s <= end_s : step.at_s <= t_s && t_s < end_s;
    level *= on ? step.level_pct / 100.0 : 1.0;
  }
  return level;
}

// Product of the highest factors of the flicker at t_s.
double flicker_level(const std::vector<waveform::Flicker>& flickers, double t_s) {
  double level = 1.0;
  for (const waveform::Flicker& flicker : flickers) {
    const bool on = flicker.at_s <= t_s && t_s < flicker.at_s + flicker.duration_s;
    level *= on ? 1.0 + 0.5 * flicker.depth_pct / 100.0 : 1.0;
  }
  return level;
}

// Sum of the amplitudes of the tones at t_s; their peaks coincide at worst.
double tones_pct(const std::vector<waveform::Tone>& tones, double t_s) {
  double sum_pct = 0.0;
  for (const waveform::Tone& tone : tones) {
    const bool on = tone.at_s <= t_s && t_s < tone.at_s + tone.duration_s;
    sum_pct += on ? tone.amplitude_pct : 0.0;
  }
  return sum_pct;
}

// Lowest and highest voltage of a period without steps, tones and offset.
struct Extremes {
  double lowest_pu;
  double highest_pu;
};

struct Peak {
  double t_s = 0.0;
  double recorded_pu = 1.0;  // voltage of the recording
  double level = 1.0;        // product of the amplitude steps
  double tones_pct = 0.0;
  double flicker = 1.0;     // highest factor
  double reached_pu = 0.0;  // with all of these, harmonics and offset
};

Peak peak_at(const Stimulus& stimulus, const waveform::ReferenceSignal& reference,
             const Extremes& period, double t_s, bool before) {
  Peak peak = {t_s, reference.voltage_pu(t_s),
               step_level(stimulus.signal.amplitude_steps, t_s, before),
               tones_pct(stimulus.signal.tones, t_s), flicker_level(stimulus.signal.flickers, t_s)};
  const double amplitude_pu = peak.recorded_pu * peak.level * peak.flicker;
  const double offset_pu = stimulus.signal.dc_offset_pct / 100.0;
  peak.reached_pu = std::max(std::abs(amplitude_pu * period.highest_pu + offset_pu),
                             std::abs(amplitude_pu * period.lowest_pu + offset_pu)) +
                    peak.tones_pct / 100.0;
  return peak;
}

// The greatest voltage. Recorded voltages are linear between points, and levels and tones are
// constant between steps, so the maximum is at one of these instants.
Peak greatest_voltage(const Stimulus& stimulus, const waveform::ReferenceSignal& reference,
                      const Extremes& period) {
  std::vector<double> instants = {0.0};
  for (const recording::TracePoint& point : stimulus.points) {
    instants.push_back(point.t_s);
  }
  for (const waveform::AmplitudeStep& step : stimulus.signal.amplitude_steps) {
    instants.push_back(step.at_s);
    instants.push_back(step.at_s + step.duration_s);
  }
  for (const waveform::Tone& tone : stimulus.signal.tones) {
    instants.push_back(tone.at_s);
  }
  for (const waveform::Flicker& flicker : stimulus.signal.flickers) {
    instants.push_back(flicker.at_s);
  }
  std::sort(instants.begin(), instants.end());  // so that the first of equal maxima is reported
  Peak peak = peak_at(stimulus, reference, period, 0.0, false);
  for (const double t_s : instants) {
    if (!(t_s <= stimulus.duration_s)) {
      continue;
    }
    for (const bool before : {true, false}) {
      const Peak other = peak_at(stimulus, reference, period, t_s, before);
      if (other.reached_pu > peak.reached_pu) {
        peak = other;
      }
    }
  }
  return peak;
}

// Lowest and highest voltage of a period with its harmonics. Sampling at 1 MHz misses less than
// 10⁻⁴ of the 50th harmonic between samples. The peaks of orders that are not whole numbers move
// along the fundamental, so that at worst all coincide.
Extremes extremes_of_a_period(const std::vector<waveform::Harmonic>& harmonics, double nominal_hz) {
  constexpr std::int64_t kFineRate_hz = 1000000;
  waveform::SignalSpec spec;
  double others_pu = 0.0;
  for (const waveform::Harmonic& harmonic : harmonics) {
    if (harmonic.order == std::floor(harmonic.order)) {
      spec.harmonics.push_back(harmonic);
    } else {
      others_pu += harmonic.amplitude_pct / 100.0;
    }
  }
  const waveform::Synthesizer synthesizer(
      waveform::reference_from_points(nominal_hz, {{0.0, nominal_hz}}), spec, kFineRate_hz);
  std::vector<float> period(static_cast<std::size_t>(kFineRate_hz / nominal_hz) + 1);
  synthesizer.render(0, period.size(), period.data());
  const auto [lowest, highest] = std::minmax_element(period.begin(), period.end());
  return {static_cast<double>(*lowest) - others_pu, static_cast<double>(*highest) + others_pu};
}

// Position of the key that contributes most to a voltage above full scale.
keys::Position cause_of(const Table& signal, const Stimulus& stimulus, const Peak& peak) {
  if (peak.level > 1.0) {
    const auto& steps = stimulus.signal.amplitude_steps;
    const auto highest =
        std::max_element(steps.begin(), steps.end(),
                         [](const auto& a, const auto& b) { return a.level_pct < b.level_pct; });
    return signal.tables("amplitude_step")
        .at(static_cast<std::size_t>(highest - steps.begin()))
        .at();
  }
  double harmonics_pct = 0.0;
  for (const waveform::Harmonic& harmonic : stimulus.signal.harmonics) {
    harmonics_pct += harmonic.amplitude_pct;
  }
  const double offset_pct = std::abs(stimulus.signal.dc_offset_pct);
  const double flicker_pct = 100.0 * (peak.flicker - 1.0);
  if (peak.tones_pct > std::max({harmonics_pct, offset_pct, flicker_pct})) {
    const auto& tones = stimulus.signal.tones;
    const auto largest = std::max_element(
        tones.begin(), tones.end(),
        [](const auto& a, const auto& b) { return a.amplitude_pct < b.amplitude_pct; });
    return signal.tables("tone").at(static_cast<std::size_t>(largest - tones.begin())).at();
  }
  if (flicker_pct > std::max(harmonics_pct, offset_pct)) {
    const auto& flickers = stimulus.signal.flickers;
    const auto deepest =
        std::max_element(flickers.begin(), flickers.end(),
                         [](const auto& a, const auto& b) { return a.depth_pct < b.depth_pct; });
    return signal.tables("flicker").at(static_cast<std::size_t>(deepest - flickers.begin())).at();
  }
  if (offset_pct > harmonics_pct) {
    return signal.at("dc_offset_pct");
  }
  return signal.at(signal.has("harmonics") ? "harmonics" : "harmonic_set");
}

// Place in the recording of the voltage that causes the peak.
recording::Place place_of(const Stimulus& stimulus, const Peak& peak) {
  const std::vector<recording::TracePoint>& points = stimulus.points;
  const auto after = std::upper_bound(
      points.begin(), points.end(), peak.t_s,
      [](double t_s, const recording::TracePoint& point) { return t_s < point.t_s; });
  auto cause = after == points.begin() ? after : std::prev(after);
  if (after != points.end() && after->voltage_pu > cause->voltage_pu && cause->t_s < peak.t_s) {
    cause = after;
  }
  return stimulus.recording.voltage_at.at(static_cast<std::size_t>(cause - points.begin()));
}

}  // namespace

void check_full_scale(const Table& signal, const Stimulus& stimulus,
                      const waveform::ReferenceSignal& reference) {
  const Extremes period = extremes_of_a_period(stimulus.signal.harmonics, reference.nominal_hz());
  const Peak peak = greatest_voltage(stimulus, reference, period);
  if (peak.reached_pu <= kFullScale_pu) {
    return;
  }
  const std::string message = fmt::format(
      "the voltage reaches {:.4g} p.u. at {:.6g} s, {} included; it must be at most {} p.u.",
      peak.reached_pu, peak.t_s,
      peak.flicker > 1.0     ? "harmonics, flicker, tones and offset"
      : peak.tones_pct > 0.0 ? "harmonics, tones and offset"
                             : "harmonics and offset",
      kFullScale_pu);
  if (!stimulus.recording.voltage_at.empty() && peak.recorded_pu > 1.0 && peak.level <= 1.0) {
    const recording::Place at = place_of(stimulus, peak);
    throw keys::ConfigurationError(
        fmt::format("{}:{}:{}: {}", stimulus.recording.path, at.line, at.column, message));
  }
  signal.refuse(cause_of(signal, stimulus, peak), message);
}

}  // namespace gsbench::profile
