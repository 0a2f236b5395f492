#include "sections.hpp"

#include <algorithm>
#include <cmath>
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
  double reached_pu = 0.0;  // with harmonics, tones and offset
};

Peak peak_at(const Stimulus& stimulus, const waveform::ReferenceSignal& reference,
             const Extremes& period, double t_s, bool before) {
  Peak peak = {t_s, reference.voltage_pu(t_s),
               step_level(stimulus.signal.amplitude_steps, t_s, before),
               tones_pct(stimulus.signal.tones, t_s)};
  const double amplitude_pu = peak.recorded_pu * peak.level;
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
// 10⁻⁴ of the 50th harmonic between samples.
Extremes extremes_of_a_period(const std::vector<waveform::Harmonic>& harmonics, double nominal_hz) {
  constexpr std::int64_t kFineRate_hz = 1000000;
  waveform::SignalSpec spec;
  spec.harmonics = harmonics;
  const waveform::Synthesizer synthesizer(
      waveform::reference_from_points(nominal_hz, {{0.0, nominal_hz}}), spec, kFineRate_hz);
  std::vector<float> period(static_cast<std::size_t>(kFineRate_hz / nominal_hz) + 1);
  synthesizer.render(0, period.size(), period.data());
  const auto [lowest, highest] = std::minmax_element(period.begin(), period.end());
  return {static_cast<double>(*lowest), static_cast<double>(*highest)};
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
  if (peak.recorded_pu > 1.0 && signal.has("trace")) {
    return signal.at("trace");
  }
  double harmonics_pct = 0.0;
  for (const waveform::Harmonic& harmonic : stimulus.signal.harmonics) {
    harmonics_pct += harmonic.amplitude_pct;
  }
  if (peak.tones_pct > std::max(harmonics_pct, std::abs(stimulus.signal.dc_offset_pct))) {
    const auto& tones = stimulus.signal.tones;
    const auto largest = std::max_element(
        tones.begin(), tones.end(),
        [](const auto& a, const auto& b) { return a.amplitude_pct < b.amplitude_pct; });
    return signal.tables("tone").at(static_cast<std::size_t>(largest - tones.begin())).at();
  }
  if (std::abs(stimulus.signal.dc_offset_pct) > harmonics_pct) {
    return signal.at("dc_offset_pct");
  }
  return signal.at(signal.has("harmonics") ? "harmonics" : "harmonic_set");
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
      peak.tones_pct > 0.0 ? "harmonics, tones and offset" : "harmonics and offset", kFullScale_pu);
  if (stimulus.recording.replaces_profile && peak.recorded_pu * peak.level > 1.0) {
    throw keys::ConfigurationError(fmt::format("{}: {}", stimulus.recording.path, message));
  }
  signal.refuse(cause_of(signal, stimulus, peak), message);
}

}  // namespace gsbench::profile
