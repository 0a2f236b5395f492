#include <algorithm>
#include <cmath>
#include <iterator>

#include <station/played_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::station {
namespace {

// Marker dips of about 170 ms, by their start times. Consecutive spacings differ, so that a missing
// or an additional dip is detected. The last one is early enough for a tracker to settle before the
// run.
constexpr double kDip_s = 0.170;
constexpr double kBefore_s[] = {0.500, 0.900, 1.460};
constexpr double kLead_s = 2.800;
constexpr double kAfter_s[] = {0.400, 0.960, 1.360};
constexpr double kTail_s = 2.000;

double turns(double x) {
  return x - std::floor(x);
}

struct Span {
  double from_s;
  double to_s;
};

struct SteadyMains {
  std::vector<Span> dips;
  waveform::Synthesizer synthesizer;
};

// Mains of constant frequency with dips. The dips start and end at zero crossings, so that the
// voltage has no step between two samples of an outlet.
SteadyMains steady_mains(double frequency_hz, double phase_turns, const double (&about_s)[3],
                         double level, std::int64_t sample_rate_hz) {
  const auto zero_crossing = [&](double t_s) {
    const double half_turns = std::ceil(2.0 * (frequency_hz * t_s + phase_turns));
    return (0.5 * half_turns - phase_turns) / frequency_hz;
  };
  std::vector<Span> dips;
  waveform::SignalSpec spec;
  spec.initial_phase_deg = 360.0 * phase_turns;
  for (const double at_s : about_s) {
    const Span dip = {zero_crossing(at_s), zero_crossing(at_s + kDip_s)};
    dips.push_back(dip);
    spec.amplitude_steps.push_back({dip.from_s, dip.to_s - dip.from_s, 100.0 * level});
  }
  return {
      dips,
      {waveform::reference_from_points(frequency_hz, {{0.0, frequency_hz}}), spec, sample_rate_hz}};
}

// Phase after the last sample of the run. The voltage then has no step there: a source could play
// one only with an error of its instant.
double turns_at_end(const profile::Plan& plan) {
  const waveform::SignalSpec& signal = plan.stimulus.signal;
  const double end_s = static_cast<double>(plan.duration_ticks()) /
                       static_cast<double>(plan.stimulus.sample_rate_hz);
  double phase_turns = signal.initial_phase_deg / 360.0 + plan.grid.nominal_hz * end_s +
                       plan.reference()->excess_cycles(end_s);
  for (const waveform::PhaseJump& jump : signal.phase_jumps) {
    phase_turns += jump.at_s < end_s ? jump.degrees / 360.0 : 0.0;
  }
  return turns(phase_turns);
}

}  // namespace

PlayedSignal::PlayedSignal(const profile::Plan& plan, bool with_markers)
    : run_ticks_(plan.duration_ticks()), noise_{plan.stimulus.noise_rms_pu(), plan.seed} {
  const std::int64_t rate_hz = plan.stimulus.sample_rate_hz;
  if (!with_markers) {
    parts_.push_back({0, plan.synthesizer()});
    return;
  }
  lead_ticks_ = waveform::tick_at(kLead_s, rate_hz);
  tail_ticks_ = waveform::tick_at(kTail_s, rate_hz);
  // Same phase and frequency as the first sample of the run: no transient at tick 0.
  const double first_hz = plan.reference()->frequency_hz(0.0);
  const double run_turns = plan.stimulus.signal.initial_phase_deg / 360.0;
  const SteadyMains before = steady_mains(first_hz, turns(run_turns - first_hz * kLead_s),
                                          kBefore_s, markers_.level, rate_hz);
  const SteadyMains after =
      steady_mains(plan.grid.nominal_hz, turns_at_end(plan), kAfter_s, markers_.level, rate_hz);
  parts_.push_back({0, before.synthesizer});
  parts_.push_back({lead_ticks_, plan.synthesizer()});
  parts_.push_back({lead_ticks_ + run_ticks_, after.synthesizer});

  const auto mark = [&](const SteadyMains& mains, std::int64_t first_tick, std::int64_t count) {
    capture::MarkedStretch stretch;
    stretch.first_tick = first_tick - lead_ticks_;
    for (const Span& dip : mains.dips) {
      stretch.dips.push_back({stretch.first_tick + waveform::tick_at(dip.from_s, rate_hz),
                              stretch.first_tick + waveform::tick_at(dip.to_s, rate_hz)});
    }
    stretch.square_sum = square_sum(first_tick, static_cast<std::size_t>(count));
    return stretch;
  };
  markers_.before = mark(before, 0, lead_ticks_);
  markers_.after = mark(after, lead_ticks_ + run_ticks_, tail_ticks_);
}

std::vector<double> PlayedSignal::square_sum(std::int64_t first_tick, std::size_t count) const {
  std::vector<float> samples(count);
  render(first_tick, count, samples.data());
  std::vector<double> sum = {0.0};
  for (const float sample : samples) {
    const auto pu = static_cast<double>(sample);
    sum.push_back(sum.back() + pu * pu);
  }
  return sum;
}

const PlayedSignal::Part& PlayedSignal::part_at(std::int64_t tick) const {
  return *std::find_if(parts_.rbegin(), std::prev(parts_.rend()),
                       [tick](const Part& part) { return part.first_tick <= tick; });
}

int PlayedSignal::nominal_hz() const {
  return static_cast<int>(std::lround(part_at(lead_ticks_).synthesizer.reference().nominal_hz()));
}

double PlayedSignal::frequency_hz(std::int64_t tick) const {
  const Part& part = part_at(tick);
  return part.synthesizer.reference().frequency_hz(static_cast<double>(tick - part.first_tick) /
                                                   static_cast<double>(sample_rate_hz()));
}

double PlayedSignal::amplitude_pu(std::int64_t tick) const {
  const Part& part = part_at(tick);
  return part.synthesizer.amplitude_pu(tick - part.first_tick);
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
