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

struct Peak {
  double t_s = 0.0;
  double recorded_pu = 1.0;  // voltage of the recording
  double level = 1.0;        // product of the amplitude steps
};

// The greatest amplitude of the fundamental. Recorded voltages are linear between points, and
// levels are constant between steps, so the maximum is at one of these instants.
Peak greatest_amplitude(const Stimulus& stimulus, const waveform::ReferenceSignal& reference) {
  std::vector<double> instants = {0.0};
  for (const recording::TracePoint& point : stimulus.points) {
    instants.push_back(point.t_s);
  }
  for (const waveform::AmplitudeStep& step : stimulus.signal.amplitude_steps) {
    instants.push_back(step.at_s);
    instants.push_back(step.at_s + step.duration_s);
  }
  std::sort(instants.begin(), instants.end());  // so that the first of equal maxima is reported
  Peak peak;
  peak.level = step_level(stimulus.signal.amplitude_steps, 0.0, false);
  peak.recorded_pu = reference.voltage_pu(0.0);
  for (const double t_s : instants) {
    if (!(t_s <= stimulus.duration_s)) {
      continue;
    }
    const double recorded_pu = reference.voltage_pu(t_s);
    for (const bool before : {true, false}) {
      const double level = step_level(stimulus.signal.amplitude_steps, t_s, before);
      if (recorded_pu * level > peak.recorded_pu * peak.level) {
        peak = {t_s, recorded_pu, level};
      }
    }
  }
  return peak;
}

// Lowest and highest voltage of a period with its harmonics. Sampling at 1 MHz misses less than
// 10⁻⁴ of the 50th harmonic between samples.
std::pair<double, double> extremes_of_a_period(const std::vector<waveform::Harmonic>& harmonics,
                                               double nominal_hz) {
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
  if (std::abs(stimulus.signal.dc_offset_pct) > harmonics_pct) {
    return signal.at("dc_offset_pct");
  }
  return signal.at(signal.has("harmonics") ? "harmonics" : "harmonic_set");
}

}  // namespace

void check_full_scale(const Table& signal, const Stimulus& stimulus,
                      const waveform::ReferenceSignal& reference) {
  const auto [lowest_pu, highest_pu] =
      extremes_of_a_period(stimulus.signal.harmonics, reference.nominal_hz());
  const double offset_pu = stimulus.signal.dc_offset_pct / 100.0;
  const Peak peak = greatest_amplitude(stimulus, reference);
  const double amplitude_pu = peak.recorded_pu * peak.level;
  const double reached_pu = std::max(std::abs(amplitude_pu * highest_pu + offset_pu),
                                     std::abs(amplitude_pu * lowest_pu + offset_pu));
  if (reached_pu <= kFullScale_pu) {
    return;
  }
  const std::string message = fmt::format(
      "the voltage reaches {:.4g} p.u. at {:.6g} s, harmonics and offset included; it must be at "
      "most {} p.u.",
      reached_pu, peak.t_s, kFullScale_pu);
  if (stimulus.recording.replaces_profile && amplitude_pu > 1.0) {
    throw keys::ConfigurationError(fmt::format("{}: {}", stimulus.recording.path, message));
  }
  signal.refuse(cause_of(signal, stimulus, peak), message);
}

}  // namespace gsbench::profile
