#include "trace_arguments.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace gsbench::cli {
namespace {

double median(std::vector<double> all) {
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

double median_hz(const std::vector<recording::TracePoint>& points) {
  std::vector<double> all;
  all.reserve(points.size());
  for (const recording::TracePoint& point : points) {
    all.push_back(point.frequency_hz);
  }
  return median(std::move(all));
}

// Rows that a recorder has left out are not gaps: they show in the steps of the time.
void warn_of_long_step(const profile::Recording& recording,
                       const std::vector<recording::TracePoint>& points) {
  std::vector<double> steps_s;
  steps_s.reserve(points.size());
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps_s.push_back(points[i].t_s - points[i - 1].t_s);
  }
  constexpr double kLong = 5.0;
  const auto longest = std::max_element(steps_s.begin(), steps_s.end());
  const double usual_s = median(steps_s);
  if (*longest > kLong * usual_s) {
    const auto before = static_cast<std::size_t>(longest - steps_s.begin());
    print_error(
        fmt::format("warning: {}: no value for {:.6g} s after {:.6g} s of the played part, "
                    "where one comes each {:.6g} s; the frequency between is interpolated",
                    recording.file, *longest, points[before].t_s, usual_s));
  }
}

}  // namespace

void add_trace(CLI::App& command, profile::Overrides& overrides) {
  recording::TraceFormat& format = overrides.trace_format;
  CLI::Option* trace =
      command
          .add_option(
              "--trace", overrides.trace_path,
              "Play this CSV recording; --trace-time and --trace-frequency name its columns. It "
              "replaces the profile's frequency (losses, points or recording), its oscillations, "
              "tones, flicker, amplitude and phase steps; noise, harmonics and DC offset stay. It "
              "is played to its end, or to --trace-until, not for the profile's duration_s")
          ->type_name("FILE");
  const auto add = [&](const char* name, auto& value, const char* type, const char* text) {
    return command.add_option(name, value, text)->type_name(type)->needs(trace);
  };
  add("--trace-time", format.time, "COLUMN",
      "Column of the times: its name, or number from 1; #2 is always a number");
  add("--trace-frequency", format.frequency, "COLUMN", "Column of the frequencies");
  add("--trace-voltage", format.voltage, "COLUMN",
      "Column of the RMS voltages; without it the voltage is nominal");
  add("--trace-nominal-voltage", format.nominal_voltage, "V",
      "Nominal voltage, in the unit of that column; without it the median of the played part");
  add("--trace-from", format.from, "TIME",
      "Start of the part to play: seconds after the first time, or date (and time)");
  add("--trace-until", format.until, "TIME", "End of the part to play, likewise");
  add("--trace-delimiter", format.delimiter, "CHARACTER",
      "Between cells; also tab, \\t or space (default: , and ; with a decimal comma)");
  add("--trace-decimal", format.decimal, "SIGN", "Decimal sign, . or ,");
  add("--trace-skip-rows", format.skip_rows, "N", "Lines above the header to skip");
  add("--trace-header-rows", format.header_rows, "N",
      "Rows above the data, names of columns in the first one; 0: no header (default: 1)");
  add("--trace-time-unit", format.time_unit, "UNIT",
      "Unit of times that are numbers: s, ms, us, ns, min, h, d");
  add("--trace-time-format", format.time_format, "FORMAT",
      "Format of dates and times, as for strptime: \"%d.%m.%Y %H:%M:%S\"");
  add("--trace-frequency-unit", format.frequency_unit, "UNIT",
      "Unit of the frequencies: Hz, mHz, kHz, rad/s, pu");
  add("--trace-frequency-offset", format.frequency_offset_hz, "HZ",
      "Is added to the frequencies: 50 for deviations from 50 Hz");
  add("--trace-gaps", format.gaps, "WORDS", "Further words for a missing value, comma-separated")
      ->delimiter(',');
}

void print_recording(const profile::Plan& plan) {
  const profile::Recording& recording = plan.stimulus.recording;
  if (recording.file.empty()) {
    return;
  }
  const std::string gaps = recording.gaps == 0   ? "no gaps"
                           : recording.gaps == 1 ? "1 of them a gap"
                                                 : fmt::format("{} of them gaps", recording.gaps);
  print_error(fmt::format("{}: rows: {}, {}; {:.6g} s are played", recording.file, recording.rows,
                          gaps, plan.stimulus.duration_s));
  warn_of_long_step(recording, plan.stimulus.points);
  // Power systems do not stay away from nominal by 2 % for the half of a recording.
  constexpr double kNear = 0.02;
  const double nominal_hz = plan.grid.nominal_hz;
  const double usual_hz = median_hz(plan.stimulus.points);
  if (std::fabs(usual_hz - nominal_hz) > kNear * nominal_hz) {
    const double other_hz = nominal_hz == 50.0 ? 60.0 : 50.0;
    print_error(fmt::format(
        "warning: {}: the median frequency is {:.6g} Hz, but the nominal frequency of the grid {} "
        "is {} Hz{}",
        recording.file, usual_hz, plan.grid.name, nominal_hz,
        std::fabs(usual_hz - other_hz) <= kNear * other_hz
            ? fmt::format("; the recording is of a system of {} Hz", other_hz)
            : ""));
  }
}

}  // namespace gsbench::cli
