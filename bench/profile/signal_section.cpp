#include "signal_section.hpp"

#include "harmonic_sets.hpp"
#include "trace_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

constexpr std::int64_t kRateStep_hz = 1000;
constexpr std::int64_t kHighestRate_hz = 32000;
constexpr int kHighestOrder = 50;
constexpr double kLevelMax_pct = 100.0 * kFullScale_pu;

std::int64_t read_sample_rate(const Table& signal) {
  constexpr std::int64_t kDefault_hz = 8000;
  const std::int64_t rate_hz =
      signal.integer("sample_rate_hz", kRateStep_hz, kHighestRate_hz).value_or(kDefault_hz);
  if (rate_hz % kRateStep_hz != 0) {
    const bool whole_reports = rate_hz * 16 % 1000 == 0;
    signal.refuse("sample_rate_hz",
                  fmt::format("sample_rate_hz is {}: {} ms is no whole number of samples; it must "
                              "be a multiple of {}",
                              rate_hz, whole_reports ? 1 : 16, kRateStep_hz));
  }
  return rate_hz;
}

std::vector<waveform::Harmonic> read_harmonics(const Table& signal, double nominal_hz,
                                               double rate_hz) {
  std::vector<waveform::Harmonic> harmonics;
  const auto add = [&](const waveform::Harmonic& harmonic, Position at) {
    const auto same = [&](const waveform::Harmonic& other) {
      return other.order == harmonic.order;
    };
    if (std::any_of(harmonics.begin(), harmonics.end(), same)) {
      signal.refuse(at, fmt::format("order {} is there twice", harmonic.order));
    }
    if (harmonic.order * nominal_hz >= rate_hz / 2.0) {
      signal.refuse(at, fmt::format("order {} lies at {} Hz, not below half of sample_rate_hz",
                                    harmonic.order, harmonic.order * nominal_hz));
    }
    harmonics.push_back(harmonic);
  };
  if (const auto set = signal.choice("harmonic_set", harmonic_set_names())) {
    for (const waveform::Harmonic& harmonic : harmonic_set(*set)) {
      add(harmonic, signal.at("harmonic_set"));
    }
  }
  for (const Row& row : signal.rows("harmonics", {"order", "pct", "deg"})) {
    const double order = row.values[0];
    if (order != std::floor(order) || order < 2.0 || order > kHighestOrder) {
      signal.refuse(row.at[0], fmt::format("order is {}; it must be a whole number from 2 to {}",
                                           order, kHighestOrder));
    }
    if (!between(0.0, 100.0).holds(row.values[1])) {
      signal.refuse(row.at[1], fmt::format("pct is {}; it must be {}", row.values[1],
                                           between(0.0, 100.0).describe()));
    }
    if (!between(-360.0, 360.0).holds(row.values[2])) {
      signal.refuse(row.at[2], fmt::format("deg is {}; it must be {}", row.values[2],
                                           between(-360.0, 360.0).describe()));
    }
    add({static_cast<int>(order), row.values[1], row.values[2]}, row.at[0]);
  }
  return harmonics;
}

std::vector<waveform::FrequencyPoint> read_points(const Table& signal, double nominal_hz,
                                                  double duration_s) {
  // Far beyond what any system survives; what lies outside is a slip of the pen.
  const Range plausible = between(0.5 * nominal_hz, 1.5 * nominal_hz);
  Range run = between(0.0, duration_s);
  run.note = "the run's duration";
  std::vector<waveform::FrequencyPoint> points;
  for (const Row& row : signal.rows("frequency", {"t_s", "hz"})) {
    const double t_s = row.values[0];
    if (!run.holds(t_s)) {
      signal.refuse(row.at[0], fmt::format("t_s is {}; it must be {}", t_s, run.describe()));
    }
    if (!points.empty() && t_s <= points.back().t_s) {
      signal.refuse(row.at[0],
                    fmt::format("t_s is {} after {}; times must ascend", t_s, points.back().t_s));
    }
    if (!plausible.holds(row.values[1])) {
      signal.refuse(row.at[1],
                    fmt::format("hz is {}; it must be {}", row.values[1], plausible.describe()));
    }
    points.push_back({t_s, row.values[1]});
  }
  return points;
}

std::vector<waveform::AmplitudeStep> read_amplitude_steps(const Table& signal, double duration_s) {
  std::vector<waveform::AmplitudeStep> steps;
  for (const Value* value : signal.tables("amplitude_step")) {
    const Table table(signal.document(), *value, "[[signal.amplitude_step]]",
                      {"at_s", "duration_s", "level_pct"});
    waveform::AmplitudeStep step{};
    step.at_s = table.required_number("at_s", within_run(duration_s));
    step.duration_s =
        table.number("duration_s", above(0.0)).value_or(std::numeric_limits<double>::infinity());
    step.level_pct = table.required_number("level_pct", between(0.0, kLevelMax_pct));
    if (table.has("duration_s") && step.at_s + step.duration_s > duration_s) {
      table.refuse("duration_s",
                   fmt::format("the step ends at {} s, after the run's {} s; leave duration_s out "
                               "for a step that lasts to the end",
                               step.at_s + step.duration_s, duration_s));
    }
    steps.push_back(step);
  }
  return steps;
}

std::vector<waveform::PhaseJump> read_phase_jumps(const Table& signal, double duration_s) {
  std::vector<waveform::PhaseJump> jumps;
  for (const Value* value : signal.tables("phase_jump")) {
    const Table table(signal.document(), *value, "[[signal.phase_jump]]", {"at_s", "degrees"});
    jumps.push_back({table.required_number("at_s", within_run(duration_s)),
                     table.required_number("degrees", between(-180.0, 180.0))});
  }
  return jumps;
}

std::vector<grid::PowerChange> read_losses(const Table& grid_section, const grid::Grid& grid,
                                           double duration_s) {
  std::vector<grid::PowerChange> losses;
  for (const Value* value : grid_section.tables("loss")) {
    const Table table(grid_section.document(), *value, "[[grid.loss]]", {"at_s", "power_mw"});
    const double at_s = table.required_number("at_s", within_run(duration_s));
    Range up_to_load = between(-grid.load_mw, grid.load_mw);
    up_to_load.note = "the grid's load";
    const double power_mw = table.required_number("power_mw", up_to_load);
    if (power_mw == 0.0) table.refuse("power_mw", "power_mw is 0: no loss at all; leave it out");
    losses.push_back({at_s, power_mw});
  }
  std::stable_sort(
      losses.begin(), losses.end(),
      [](const grid::PowerChange& a, const grid::PowerChange& b) { return a.at_s < b.at_s; });
  double balance_mw = 0.0;
  for (const grid::PowerChange& loss : losses) {
    balance_mw += loss.power_mw;
    if (std::abs(balance_mw) > grid.load_mw) {
      grid_section.refuse("loss", fmt::format("the losses add up to {} MW by {} s, more than the "
                                              "grid's load of {} MW",
                                              balance_mw, loss.at_s, grid.load_mw));
    }
  }
  return losses;
}

// Product of the amplitude steps that are on at t_s, just before it where `before`.
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
  double recorded_pu = 1.0;  // of the recording
  double level = 1.0;        // of the amplitude steps
};

// When the fundamental is greatest. Voltages go straight between the recording's points and levels
// stand still between steps, so that it is at one of those instants.
Peak greatest_amplitude(const Stimulus& stimulus, const waveform::Truth& truth) {
  std::vector<double> instants = {0.0};
  for (const waveform::TracePoint& point : stimulus.trace) instants.push_back(point.t_s);
  for (const waveform::AmplitudeStep& step : stimulus.signal.amplitude_steps) {
    instants.push_back(step.at_s);
    instants.push_back(step.at_s + step.duration_s);
  }
  Peak peak;
  peak.level = step_level(stimulus.signal.amplitude_steps, 0.0, false);
  peak.recorded_pu = truth.voltage_pu(0.0);
  for (const double t_s : instants) {
    if (!(t_s <= stimulus.duration_s)) continue;
    const double recorded_pu = truth.voltage_pu(t_s);
    for (const bool before : {true, false}) {
      const double level = step_level(stimulus.signal.amplitude_steps, t_s, before);
      if (recorded_pu * level > peak.recorded_pu * peak.level) peak = {t_s, recorded_pu, level};
    }
  }
  return peak;
}

// Just one thing can say how the frequency goes.
void refuse_second_source(const Table& signal, const Table& grid_section) {
  const char* message =
      "the frequency comes from [[grid.loss]], from frequency points or from a recording; this "
      "profile gives more than one of them";
  if (signal.has("trace") && (signal.has("frequency") || grid_section.has("loss"))) {
    signal.refuse("trace", message);
  }
  if (signal.has("frequency") && grid_section.has("loss")) signal.refuse("frequency", message);
}

struct Extremes {
  double lowest_pu = 0.0;
  double highest_pu = 0.0;
};

// Of a period with its harmonics, whose phases go with the fundamental's: at 1 MHz, less than 10⁻⁴
// of the 50th harmonic is missed between samples.
Extremes extremes_of_a_period(const std::vector<waveform::Harmonic>& harmonics, double nominal_hz) {
  constexpr std::int64_t kFineRate_hz = 1000000;
  waveform::SignalSpec spec;
  spec.harmonics = harmonics;
  const waveform::Synthesizer synthesizer(
      waveform::truth_from_points(nominal_hz, {{0.0, nominal_hz}}), spec, kFineRate_hz);
  std::vector<float> period(static_cast<std::size_t>(kFineRate_hz / nominal_hz) + 1);
  synthesizer.render(0, period.size(), period.data());
  const auto [lowest, highest] = std::minmax_element(period.begin(), period.end());
  return {static_cast<double>(*lowest), static_cast<double>(*highest)};
}

// What to point at where a signal goes too high: what adds most to it.
Position cause_of(const Table& signal, const Stimulus& stimulus, const Peak& peak) {
  if (peak.level > 1.0) {
    const auto& steps = stimulus.signal.amplitude_steps;
    const auto highest =
        std::max_element(steps.begin(), steps.end(),
                         [](const auto& a, const auto& b) { return a.level_pct < b.level_pct; });
    return signal.tables("amplitude_step")[static_cast<std::size_t>(highest - steps.begin())]->at;
  }
  if (peak.recorded_pu > 1.0 && signal.has("trace")) return signal.at("trace");
  double harmonics_pct = 0.0;
  for (const waveform::Harmonic& harmonic : stimulus.signal.harmonics) {
    harmonics_pct += harmonic.amplitude_pct;
  }
  if (std::abs(stimulus.signal.dc_offset_pct) > harmonics_pct) return signal.at("dc_offset_pct");
  return signal.at(signal.has("harmonics") ? "harmonics" : "harmonic_set");
}

}  // namespace

void check_full_scale(const Table& signal, const Stimulus& stimulus, const waveform::Truth& truth) {
  const Extremes period = extremes_of_a_period(stimulus.signal.harmonics, truth.nominal_hz());
  const double offset_pu = stimulus.signal.dc_offset_pct / 100.0;
  const Peak peak = greatest_amplitude(stimulus, truth);
  const double amplitude_pu = peak.recorded_pu * peak.level;
  const double highest_pu = std::max(std::abs(amplitude_pu * period.highest_pu + offset_pu),
                                     std::abs(amplitude_pu * period.lowest_pu + offset_pu));
  if (highest_pu <= kFullScale_pu) return;
  const std::string message = fmt::format(
      "the voltage reaches {:.4g} pu (at {:.6g} s, with harmonics and offset); a source plays {} "
      "pu "
      "at most",
      highest_pu, peak.t_s, kFullScale_pu);
  if (stimulus.recording.replaces_profile && amplitude_pu > 1.0) {
    throw ConfigurationError(fmt::format("{}: {}", stimulus.recording.path, message));
  }
  signal.refuse(cause_of(signal, stimulus, peak), message);
}

Stimulus read_stimulus(const Table& signal, const Table& grid_section, const grid::Grid& grid,
                       bool skip_recording) {
  refuse_second_source(signal, grid_section);
  Stimulus stimulus;
  stimulus.sample_rate_hz = read_sample_rate(signal);
  stimulus.noise_pct = signal.number("noise_pct", between(0.0, 100.0)).value_or(0.0);
  const auto duration_s = signal.number("duration_s", between(kShortestRun_s, kLongestRun_s));
  if (!signal.has("trace")) {
    if (!duration_s) signal.refuse_missing("duration_s", "the length of the run, in seconds");
    stimulus.duration_s = *duration_s;
  } else if (skip_recording) {
    stimulus.duration_s = duration_s.value_or(kLongestRun_s);
  } else {
    read_trace_section(signal, grid.nominal_hz, stimulus);
    if (duration_s && *duration_s > stimulus.duration_s) {
      signal.refuse("duration_s", fmt::format("duration_s is {}; the recording ends at {} s",
                                              *duration_s, stimulus.duration_s));
    }
    stimulus.duration_s = duration_s.value_or(stimulus.duration_s);
  }
  stimulus.points = read_points(signal, grid.nominal_hz, stimulus.duration_s);
  if (!stimulus.points.empty()) stimulus.kind = TruthKind::kPoints;
  stimulus.losses = read_losses(grid_section, grid, stimulus.duration_s);
  stimulus.signal.harmonics =
      read_harmonics(signal, grid.nominal_hz, static_cast<double>(stimulus.sample_rate_hz));
  stimulus.signal.amplitude_steps = read_amplitude_steps(signal, stimulus.duration_s);
  stimulus.signal.phase_jumps = read_phase_jumps(signal, stimulus.duration_s);
  stimulus.signal.dc_offset_pct =
      signal.number("dc_offset_pct", between(-100.0, 100.0)).value_or(0.0);
  stimulus.signal.initial_phase_deg =
      signal.number("initial_phase_deg", between(-360.0, 360.0)).value_or(0.0);
  return stimulus;
}

}  // namespace gsbench::profile
