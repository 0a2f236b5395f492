#include "generator_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gsbench::emulation {

namespace {

constexpr double kOutput_ohm = 50.0;
constexpr double kHighestPeak_v = 10.0;  // into an open circuit
constexpr double kLowest_vpp = 0.002;    // into an open circuit

// The part of the open-circuit voltage that a load gets.
double divider(double load_ohm) {
  return std::isinf(load_ohm) ? 1.0 : load_ohm / (load_ohm + kOutput_ohm);
}

bool plays_otherwise(const GeneratorSettings& a, const GeneratorSettings& b) {
  return a.function != b.function || a.waveform != b.waveform || a.point_rate != b.point_rate ||
         a.burst_on != b.burst_on || a.trigger != b.trigger || a.burst_cycles != b.burst_cycles ||
         a.burst_period_s != b.burst_period_s;
}

}  // namespace

GeneratorState::GeneratorState(const GeneratorOptions& options)
    : options_(options),
      facts_(facts_of(options.model)),
      settings_(facts_.defaults),
      player_(options.time) {
  play(true);
}

void GeneratorState::set(const GeneratorSettings& settings) {
  const bool otherwise = plays_otherwise(settings, settings_);
  const bool stuck = settings_.output_on && faults_.ignores_output_off;
  settings_ = settings;
  settings_.output_on = settings_.output_on || stuck;
  if (faults_.silent_limit_vpp) {
    settings_.amplitude_vpp = std::min(settings_.amplitude_vpp, *faults_.silent_limit_vpp);
  }
  play(otherwise);
}

void GeneratorState::set_load(double load_ohm) {
  const double ratio = divider(load_ohm) / divider(settings_.load_ohm);
  settings_.amplitude_vpp *= ratio;
  settings_.offset_v *= ratio;
  settings_.load_ohm = load_ohm;
  play(false);
}

void GeneratorState::set_idle(std::optional<double> idle) {
  idle_ = idle;
  play(false);
}

void GeneratorState::restart() {
  play(true);
}

void GeneratorState::reset() {
  const bool stuck = settings_.output_on && faults_.ignores_output_off;
  settings_ = facts_.defaults;
  settings_.output_on = stuck;
  idle_.reset();
  play(true);
}

void GeneratorState::lose_power() {
  if (!facts_.keeps_waveforms) {
    waveforms_.clear();
  }
  settings_.output_on = false;
  reset();
}

double GeneratorState::lowest_vpp() const {
  return kLowest_vpp * divider(settings_.load_ohm);
}

double GeneratorState::highest_peak_v() const {
  return kHighestPeak_v * divider(settings_.load_ohm);
}

double GeneratorState::highest_vpp(double offset_v) const {
  return 2 * (highest_peak_v() - std::abs(offset_v));
}

double GeneratorState::highest_frequency_hz(GeneratorFunction function) const {
  return function == GeneratorFunction::kArbitrary ? facts_.highest_arbitrary_hz
                                                   : facts_.highest_frequency_hz;
}

bool GeneratorState::has_room(std::size_t points) const {
  std::size_t taken = points;
  for (const auto& [name, waveform] : waveforms_) {
    taken += waveform->points();
  }
  return !faults_.memory_full && taken <= facts_.memory_points;
}

void GeneratorState::store(GeneratorWaveform waveform) {
  std::string name = waveform.name();
  const bool played = name == settings_.waveform;
  waveforms_[std::move(name)] = std::make_shared<const GeneratorWaveform>(std::move(waveform));
  if (played) {
    play(true);
  }
}

const GeneratorWaveform* GeneratorState::find(const std::string& name) const {
  const auto found = waveforms_.find(name);
  return found == waveforms_.end() ? nullptr : found->second.get();
}

std::vector<std::string> GeneratorState::names() const {
  std::vector<std::string> names;
  for (const auto& [name, waveform] : waveforms_) {
    names.push_back(name);
  }
  return names;
}

void GeneratorState::forget_waveforms() {
  waveforms_.clear();
  settings_.waveform.clear();
  play(true);
}

std::shared_ptr<const GeneratorWaveform> GeneratorState::played_waveform() const {
  const auto found = waveforms_.find(settings_.waveform);
  const auto selected = found == waveforms_.end() ? nullptr : found->second;
  if (selected == selected_ && derived_for_ == settings_.point_rate) {
    return derived_;
  }
  selected_ = selected;
  derived_for_ = settings_.point_rate;
  const bool by_table = settings_.point_rate == PointRate::kFrequency && facts_.table_points > 0;
  if (!selected || (!by_table && facts_.dropped_bits == 0)) {
    derived_ = selected;
  } else {
    derived_ = std::make_shared<const GeneratorWaveform>(
        (by_table ? selected->in_table(facts_.table_points) : *selected)
            .without_bits(facts_.dropped_bits));
  }
  return derived_;
}

double GeneratorState::rate_hz(const GeneratorWaveform& waveform) const {
  return settings_.point_rate == PointRate::kSampleRate
             ? settings_.sample_rate_hz / static_cast<double>(waveform.points())
             : settings_.frequency_hz;
}

void GeneratorState::play(bool restart) {
  Playback playback;
  playback.relay_on = settings_.output_on;
  playback.function = settings_.function;
  playback.between = settings_.between;
  double cycles_a_second = settings_.frequency_hz;
  if (settings_.function == GeneratorFunction::kArbitrary) {
    playback.waveform = played_waveform();
    if (playback.waveform) {
      cycles_a_second = rate_hz(*playback.waveform);
    }
  }
  playback.cycles_per_step =
      cycles_a_second * (1 + options_.clock_ppm * 1e-6) / static_cast<double>(TrueTime::kRate_hz);
  const double turns = settings_.phase_deg / 360;
  playback.phase = turns - std::floor(turns);
  playback.duty = settings_.duty_pct / 100;
  playback.symmetry = settings_.symmetry_pct / 100;
  const double ratio = divider(options_.connected_ohm) / divider(settings_.load_ohm);
  playback.centre_v = settings_.offset_v * ratio;
  playback.half_v = settings_.amplitude_vpp / 2 * ratio * (settings_.inverted ? -1 : 1);
  playback.burst = settings_.burst_on;
  playback.burst_cycles = settings_.burst_cycles;
  if (settings_.trigger == TriggerSource::kInternal) {
    const double steps = std::max(settings_.burst_period_s * TrueTime::kRate_hz,
                                  settings_.burst_cycles / playback.cycles_per_step);
    playback.period_steps =
        steps < 1e15 ? std::max<std::int64_t>(1, std::llround(std::ceil(steps))) : 0;
  }
  playback.idle = idle_;
  player_.change(playback, restart);
}

}  // namespace gsbench::emulation
