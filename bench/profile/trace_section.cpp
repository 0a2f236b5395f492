#include "sections.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::ConfigurationError;

std::vector<recording::TracePoint> read_recording(const std::string& path,
                                                  const recording::TraceColumns& columns) {
  try {
    return recording::read_trace(path, columns);
  } catch (const std::runtime_error& error) {  // its message contains file, line and column
    throw ConfigurationError(error.what());
  }
}

// The same limits as for the frequency points and the duration of a profile.
void check(const std::vector<recording::TracePoint>& points, const std::string& path,
           double nominal_hz) {
  const double length_s = points.back().t_s;
  const bool is_short = length_s < kShortestRun_s;
  if (is_short || !(length_s <= kLongestRun_s)) {
    throw ConfigurationError(fmt::format("{}: the recording is {} s long; it must be at {} {} s",
                                         path, length_s, is_short ? "least" : "most",
                                         is_short ? kShortestRun_s : kLongestRun_s));
  }
  for (const recording::TracePoint& point : points) {
    if (!(point.frequency_hz >= 0.5 * nominal_hz && point.frequency_hz <= 1.5 * nominal_hz)) {
      throw ConfigurationError(fmt::format(
          "{}: the frequency is {} Hz at {} s from the start; it must be {} … {} Hz (0.5 … 1.5 of "
          "nominal)",
          path, point.frequency_hz, point.t_s, 0.5 * nominal_hz, 1.5 * nominal_hz));
    }
  }
}

void use(std::vector<recording::TracePoint> points, Recording recording, double nominal_hz,
         Stimulus& stimulus) {
  check(points, recording.path, nominal_hz);
  stimulus.duration_s = points.back().t_s;
  stimulus.points = std::move(points);
  recording.sha256 = sha256_of_file(recording.path);
  stimulus.recording = std::move(recording);
}

}  // namespace

keys::Key trace_keys() {
  return keys::table(
      "trace",
      "A recording as CSV with a header line. It must be 0.1 … 10⁵ s long and stay within 0.5 … "
      "1.5 of nominal. A row with `NaN` in a used column is skipped, and the curve is interpolated "
      "across the gap. Run records and reports contain the file name, the columns and the SHA-256 "
      "of the content. `--trace` on the command line plays another recording in full length, in "
      "place of the profile's losses, frequency points or recording, oscillations, tones, "
      "amplitude steps "
      "and phase steps; noise, harmonics and DC offset stay.",
      {keys::text("file", "path of the CSV file, relative to the profile").require(),
       keys::text("time", "name of the time column: seconds, or date and time of day").require(),
       keys::text("frequency", "name of the frequency column, in Hz").require(),
       keys::text("voltage", "name of the RMS voltage column").or_else("none: nominal voltage"),
       keys::number("nominal_voltage", "as the column", keys::above(0.0), "voltage of 1 p.u.")
           .or_else("median of the column"),
       keys::number("from_s", "s", keys::at_least(0.0),
                    "start of the part to play; the first row in it becomes time 0")
           .by_default(0.0),
       keys::number("until_s", "s", keys::above(0.0), "end of the part to play")
           .permits("above `from_s`")
           .or_else("to the end")});
}

void read_trace_section(const keys::Table& signal, double nominal_hz, Stimulus& stimulus) {
  const keys::Table table = signal.table("trace");
  const std::string file = table.text("file");
  const std::string path = resolve(file, table.document().path);
  recording::TraceColumns columns;
  columns.time = table.text("time");
  columns.frequency = table.text("frequency");
  columns.voltage = table.find_text("voltage").value_or("");
  columns.nominal_voltage = table.find_number("nominal_voltage").value_or(0.0);
  if (columns.voltage.empty() && table.has("nominal_voltage")) {
    table.refuse("nominal_voltage",
                 "nominal_voltage is given without a voltage column; give voltage = \"…\", or omit "
                 "nominal_voltage");
  }
  const double from_s = table.number("from_s");
  const auto until_s = table.find_number("until_s", keys::above(from_s));
  if (!is_regular_file(path)) {
    table.refuse("file", fmt::format("file is \"{}\"; there is no file {}", file, path));
  }

  auto points = read_recording(path, columns);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const recording::TracePoint& point) {
                                return point.t_s < from_s || (until_s && point.t_s > *until_s);
                              }),
               points.end());
  if (points.size() < 2) {
    table.refuse(table.has("from_s")    ? "from_s"
                 : table.has("until_s") ? "until_s"
                                        : "file",
                 fmt::format("from_s and until_s leave fewer than two rows of {} to play", path));
  }
  const double first_s = points.front().t_s;
  for (recording::TracePoint& point : points) {
    point.t_s -= first_s;
  }
  use(std::move(points), {file, path, "", columns, false}, nominal_hz, stimulus);
}

void replace_by_recording(const std::string& path, const recording::TraceColumns& columns,
                          double nominal_hz, Stimulus& stimulus) {
  if (columns.time.empty() || columns.frequency.empty()) {
    throw ConfigurationError(
        "--trace requires --trace-time and --trace-frequency, the names of the columns");
  }
  if (!is_regular_file(path)) {
    throw ConfigurationError(fmt::format("{}: is not an existing file", path));
  }
  auto points = read_recording(path, columns);
  if (points.size() < 2) {
    throw ConfigurationError(fmt::format("{}: fewer than two rows to play", path));
  }
  stimulus.losses.clear();
  stimulus.initial_deviation_hz = 0.0;
  stimulus.oscillations.clear();
  stimulus.signal.amplitude_steps.clear();
  stimulus.signal.phase_jumps.clear();
  stimulus.signal.tones.clear();
  use(std::move(points), {path, path, "", columns, true}, nominal_hz, stimulus);
}

}  // namespace gsbench::profile
