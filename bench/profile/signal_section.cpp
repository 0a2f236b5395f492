#include "sections.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Range;
using keys::Table;

constexpr std::int64_t kRateStep_hz = 1000;
constexpr std::int64_t kHighestRate_hz = 32000;
constexpr double kLevelMax_pct = 100.0 * kFullScale_pu;

const char* const kSignalMeaning =
    "The voltage that the source plays. Its frequency comes from one of `[[grid.loss]]`, "
    "`frequency` and `[signal.trace]`. The voltage must stay within ± 1.5 p.u. of the nominal peak "
    "amplitude, including amplitude steps, flicker, recorded voltage, harmonics, tones and offset. "
    "Noise is not counted, because an outlet's input clips it.";

Key frequency_key() {
  return keys::array(
      "frequency",
      keys::row({keys::number("t_s", "s", keys::at_least(0.0), ""),
                 keys::number("hz", "Hz", keys::above(0.0), "")}),
      "frequency points in ascending time, 0.5 … 1.5 of nominal; monotone cubic interpolation, "
      "constant before the first point and after the last");
}

Key amplitude_step_keys() {
  return keys::tables(
      "amplitude_step", "Dips, swells and interruptions. Overlapping steps multiply.",
      {time_in_run("start; takes effect from the first sample at or after this time"),
       duration_key(),
       keys::number("level_pct", "%", keys::between(0.0, kLevelMax_pct),
                    "remaining amplitude; 0 is an interruption")
           .require()});
}

// 0 is not permitted: no instrument plays without a deviation.
Key tolerance(const char* name, const char* unit, double fallback, const char* of) {
  return keys::number(name, unit, {0.0, 1000.0, true},
                      fmt::format("largest accepted deviation of the played {}; a source that "
                                  "deviates more is refused",
                                  of))
      .by_default(fallback);
}

Key phase_jump_keys() {
  return keys::tables("phase_jump", "Steps of the phase angle.",
                      {time_in_run("time; takes effect from the first sample at or after it"),
                       keys::number("degrees", "degrees", keys::between(-180.0, 180.0),
                                    "size of the phase step; positive: advance")
                           .require()});
}

std::int64_t read_sample_rate(const Table& signal) {
  const std::int64_t rate_hz = signal.whole("sample_rate_hz");
  if (rate_hz % kRateStep_hz != 0) {
    signal.refuse("sample_rate_hz",
                  fmt::format("sample_rate_hz is {}; it must be a multiple of {}, so that 1 ms and "
                              "16 ms are whole numbers of samples",
                              rate_hz, kRateStep_hz));
  }
  return rate_hz;
}

std::vector<recording::TracePoint> read_points(const Table& signal, double nominal_hz,
                                               double duration_s) {
  // Far beyond what any power system survives: a value outside is a typing error.
  const Range plausible = keys::between(0.5 * nominal_hz, 1.5 * nominal_hz);
  const Range run = {0.0, duration_s, false, false, "the run's duration"};
  std::vector<recording::TracePoint> points;
  for (const keys::Row& row : signal.rows("frequency")) {
    const double t_s = row.values[0];
    if (!run.holds(t_s)) {
      signal.refuse(row.at[0], fmt::format("t_s is {}; it must be {}", t_s, run.describe()));
    }
    if (!points.empty() && t_s <= points.back().t_s) {
      signal.refuse(row.at[0],
                    fmt::format("t_s is {}; it must be above {}, the time of the previous point",
                                t_s, points.back().t_s));
    }
    if (!plausible.holds(row.values[1])) {
      signal.refuse(row.at[1],
                    fmt::format("hz is {}; it must be {}", row.values[1], plausible.describe()));
    }
    points.push_back({t_s, row.values[1]});
  }
  return points;
}

std::vector<waveform::AmplitudeStep> read_amplitude_steps(const Table& signal, const RunTime& run) {
  std::vector<waveform::AmplitudeStep> steps;
  for (const Table& table : signal.tables("amplitude_step")) {
    const Span span = read_span(table, run, "step");
    steps.push_back({span.at_s, span.duration_s, table.number("level_pct")});
  }
  return steps;
}

std::vector<waveform::PhaseJump> read_phase_jumps(const Table& signal, const RunTime& run) {
  std::vector<waveform::PhaseJump> jumps;
  for (const Table& table : signal.tables("phase_jump")) {
    jumps.push_back({table.number("at_s", run.starts()), table.number("degrees")});
  }
  return jumps;
}

void refuse_second_source(const Table& signal, const Table& grid_section) {
  const char* message =
      "the frequency has more than one source; give only one of [[grid.loss]], frequency and "
      "[signal.trace]";
  if (signal.has("trace") && (signal.has("frequency") || grid_section.has("loss"))) {
    signal.refuse("trace", message);
  }
  if (signal.has("frequency") && grid_section.has("loss")) {
    signal.refuse("frequency", message);
  }
  if (grid_section.has("frequency_before_hz") && (signal.has("frequency") || signal.has("trace"))) {
    grid_section.refuse("frequency_before_hz",
                        "frequency_before_hz is only valid if the frequency follows from the grid; "
                        "omit it, or frequency and [signal.trace]");
  }
}

}  // namespace

Key signal_keys() {
  return keys::table(
             "signal", kSignalMeaning,
             {keys::number("duration_s", "s", keys::between(kShortestRun_s, kLongestRun_s),
                           "length of the run; `--trace` plays its recording instead, however long")
                  .or_else("required; with a recording: its length"),
              keys::whole("sample_rate_hz", "Hz", kRateStep_hz, kHighestRate_hz,
                          "sampling rate of the signal")
                  .permits("1000 … 32000, a multiple of 1000")
                  .by_default(8000),
              keys::number("noise_pct", "%", keys::between(0.0, 100.0),
                           "white noise, RMS, relative to the nominal peak amplitude")
                  .by_default(0.0),
              harmonics_key(), harmonic_set_key(), frequency_key(),
              keys::number("dc_offset_pct", "%", keys::between(-100.0, 100.0),
                           "DC offset, relative to the nominal peak amplitude")
                  .by_default(0.0),
              keys::number("initial_phase_deg", "degrees", keys::between(-360.0, 360.0),
                           "phase of the fundamental at the start")
                  .by_default(0.0),
              tolerance("frequency_tolerance_mhz", "mHz", Tolerances{}.frequency_mhz,
                        "frequency, over windows of 200 ms"),
              tolerance("voltage_tolerance_pct", "%", Tolerances{}.voltage_pct,
                        "voltage, with the accuracy of its amplitude, relative to the nominal peak "
                        "amplitude"),
              tolerance("time_tolerance_ms", "ms", Tolerances{}.time_ms, "time"),
              oscillation_keys(), amplitude_step_keys(), phase_jump_keys(), flicker_keys(),
              tone_keys(), trace_keys()})
      .require("the signal to play, e.g. [signal] duration_s = 6.0");
}

Stimulus read_stimulus(const Table& signal, const Table& grid_section, const grid::Grid& grid,
                       bool skip_recording, const Copies& copies) {
  refuse_second_source(signal, grid_section);
  Stimulus stimulus;
  stimulus.sample_rate_hz = read_sample_rate(signal);
  stimulus.noise_pct = signal.number("noise_pct");
  const auto duration_s = signal.find_number("duration_s");
  if (!signal.has("trace")) {
    if (!duration_s) {
      signal.refuse_missing("duration_s", "the length of the run in seconds");
    }
    stimulus.duration_s = *duration_s;
  } else if (skip_recording) {
    stimulus.duration_s = duration_s.value_or(kLongestRun_s);
  } else {
    read_trace_section(signal, grid.nominal_hz, copies, stimulus);
    if (duration_s && *duration_s > stimulus.duration_s) {
      signal.refuse("duration_s",
                    fmt::format("duration_s is {}; it must be at most {} (the recording's length)",
                                *duration_s, stimulus.duration_s));
    }
    stimulus.duration_s = duration_s.value_or(stimulus.duration_s);
  }
  if (signal.has("frequency")) {
    stimulus.points = read_points(signal, grid.nominal_hz, stimulus.duration_s);
  }
  stimulus.initial_deviation_hz = read_initial_deviation_hz(grid_section, grid);
  const RunTime run = {stimulus.duration_s, stimulus.sample_rate_hz};
  stimulus.losses = read_losses(grid_section, grid, run);
  stimulus.oscillations = read_oscillations(signal, run);
  stimulus.signal.harmonics =
      read_harmonics(signal, grid.nominal_hz, static_cast<double>(stimulus.sample_rate_hz));
  stimulus.signal.amplitude_steps = read_amplitude_steps(signal, run);
  stimulus.signal.phase_jumps = read_phase_jumps(signal, run);
  stimulus.signal.flickers = read_flickers(signal, run);
  stimulus.signal.tones = read_tones(signal, run);
  stimulus.signal.dc_offset_pct = signal.number("dc_offset_pct");
  stimulus.signal.initial_phase_deg = signal.number("initial_phase_deg");
  stimulus.tolerances = {signal.number("frequency_tolerance_mhz"),
                         signal.number("voltage_tolerance_pct"),
                         signal.number("time_tolerance_ms")};
  return stimulus;
}

}  // namespace gsbench::profile
