#include "sections.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::ConfigurationError;
using keys::Key;
using keys::Table;

// The options of recording::TraceFormat, with the names of its visit_fields().
std::vector<Key> format_keys() {
  return {
      keys::text("time", "name of the time column: seconds, or date and time of day").require(),
      keys::text("frequency", "name of the frequency column, in Hz").require(),
      keys::text("voltage", "name of the RMS voltage column").or_else("none: nominal voltage"),
      keys::number("nominal_voltage", "as the column", keys::above(0.0), "voltage of 1 p.u.")
          .or_else("median of the played part"),
      keys::text_or_number("from_s", "s", keys::at_least(0.0),
                           "start of the part to play: seconds after the first row, or date "
                           "and time as in the recording; the first row in it becomes time 0")
          .permits("at least 0, or text")
          .by_default(0.0),
      keys::text_or_number("until_s", "s", keys::above(0.0), "end of the part to play, as `from_s`")
          .permits("above `from_s`, or text")
          .or_else("to the end")};
}

struct ReadFormat {
  const Table& table;

  void operator()(const char* key, std::string& value) const {
    value = table.has(key) ? table.text(key) : value;
  }
  void operator()(const char* key, double& value) const {
    value = table.find_number(key).value_or(value);
  }
};

struct WriteFormat {
  std::string& text;

  void operator()(const char* key, const std::string& value) const {
    if (!value.empty()) {
      text += fmt::format("{} = {}\n", key, keys::quoted(value));
    }
  }
  void operator()(const char* key, double value) const {
    if (value != 0.0) {
      text += fmt::format("{} = {}\n", key, value);
    }
  }
};

recording::TraceFormat read_format(const Table& table) {
  recording::TraceFormat format;
  recording::visit_fields(format, ReadFormat{table});
  if (format.voltage.empty() && table.has("nominal_voltage")) {
    table.refuse("nominal_voltage",
                 "nominal_voltage is given without a voltage column; give voltage = \"…\", or omit "
                 "nominal_voltage");
  }
  return format;
}

// Sets the points, the recording and the duration. `duration_s`: time to play. Throws FormatError.
void use(Recording recording, double duration_s, double nominal_hz, const Copies& copies,
         Stimulus& stimulus) {
  // The same limits as for the frequency points and the duration of a profile.
  const recording::TraceLimits limits = {0.5 * nominal_hz, 1.5 * nominal_hz, kShortestRun_s,
                                         kLongestRun_s, duration_s};
  try {
    const std::string text =
        copies.recording ? *copies.recording : recording::read_trace_file(recording.path);
    recording::Trace trace = recording::read_trace(text, recording.path, recording.format, limits);
    recording.sha256 = copies.recording ? "" : sha256(text);
    recording.played_text = std::move(trace.text);
    recording.rows = trace.rows;
    recording.gaps = trace.gaps;
    stimulus.duration_s = trace.points.back().t_s;
    stimulus.points = std::move(trace.points);
  } catch (const recording::FormatError&) {
    throw;
  } catch (const std::runtime_error& error) {  // its message contains file, line and column
    throw ConfigurationError(error.what());
  }
  stimulus.recording = std::move(recording);
}

// The option of the command line for a key: "from_s" is --trace-from.
std::string option_name(std::string key) {
  constexpr const char* kUnits[] = {"_s", "_hz"};
  for (const std::string unit : kUnits) {
    if (key.size() > unit.size() && key.compare(key.size() - unit.size(), unit.size(), unit) == 0) {
      key.resize(key.size() - unit.size());
    }
  }
  std::replace(key.begin(), key.end(), '_', '-');
  return "--trace-" + key;
}

}  // namespace

Key trace_keys() {
  std::vector<Key> all = {
      keys::text("file", "path of the CSV file, relative to the profile").require()};
  for (Key& key : format_keys()) {
    all.push_back(std::move(key));
  }
  return keys::table(
      "trace",
      "A recording as CSV with a header line. The played part must be 0.1 … 10⁵ s long and stay "
      "within 0.5 … 1.5 of nominal. Rows outside `from_s` … `until_s`, and after `duration_s`, may "
      "have any content. A row in which a used column is empty, `NaN`, `NA` or `null` is a gap, "
      "and "
      "the curve is interpolated across it. Run records and reports contain the file name, the "
      "columns and the SHA-256 of the content. `--trace` on the command line plays another "
      "recording, in place of the profile's losses, frequency points or recording, oscillations, "
      "tones, amplitude steps and phase steps; noise, harmonics and DC offset stay.",
      std::move(all));
}

std::string trace_options(const recording::TraceFormat& format) {
  std::string text;
  recording::visit_fields(format, WriteFormat{text});
  return text;
}

recording::TraceFormat trace_format(const std::string& options) {
  static const Key keys = keys::table("the options of a recording", "", format_keys());
  const keys::Document document = keys::parse_toml(options, "options");
  return read_format(Table(document, keys));
}

void read_trace_section(const Table& signal, double nominal_hz, const Copies& copies,
                        Stimulus& stimulus) {
  const Table table = signal.table("trace");
  const std::string file = table.text("file");
  Recording recording;
  recording.file = file;
  recording.path = resolve(file, table.document().path);
  recording.format = read_format(table);
  if (!copies.recording && !is_regular_file(recording.path)) {
    table.refuse("file", fmt::format("file is \"{}\"; there is no file {}", file, recording.path));
  }
  try {
    use(std::move(recording),
        signal.find_number("duration_s").value_or(std::numeric_limits<double>::infinity()),
        nominal_hz, copies, stimulus);
  } catch (const recording::FormatError& error) {
    table.refuse(table.has(error.key) ? error.key : "file", error.what());
  }
}

void replace_by_recording(const Overrides& overrides, double nominal_hz, const Copies& copies,
                          Stimulus& stimulus) {
  Recording recording;
  recording.file = overrides.trace_path;
  recording.path = overrides.trace_path;
  recording.format = overrides.trace_format;
  recording.replaces_profile = true;
  if (recording.format.time.empty() || recording.format.frequency.empty()) {
    throw ConfigurationError(
        "--trace requires --trace-time and --trace-frequency, the names of the columns");
  }
  if (!copies.recording && !is_regular_file(recording.path)) {
    throw ConfigurationError(fmt::format("{}: is not an existing file", recording.path));
  }
  stimulus.losses.clear();
  stimulus.initial_deviation_hz = 0.0;
  stimulus.oscillations.clear();
  stimulus.signal.amplitude_steps.clear();
  stimulus.signal.phase_jumps.clear();
  stimulus.signal.tones.clear();
  try {
    use(std::move(recording), std::numeric_limits<double>::infinity(), nominal_hz, copies,
        stimulus);
  } catch (const recording::FormatError& error) {
    throw ConfigurationError(fmt::format("{}: {}", option_name(error.key), error.what()));
  }
}

}  // namespace gsbench::profile
