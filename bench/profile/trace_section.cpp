#include "sections.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::ConfigurationError;
using keys::Table;

// The same limits as for the frequency points and the duration of a profile.
recording::TraceLimits limits_of(double nominal_hz) {
  return {nominal_hz, 0.5 * nominal_hz, 1.5 * nominal_hz, kShortestRun_s, kLongestRun_s};
}

// Sets the points, the recording and the duration. Throws FormatError.
void use(Recording recording, const recording::TraceLimits& limits, const Copies& copies,
         Stimulus& stimulus) {
  try {
    const std::string text =
        copies.recording ? *copies.recording : recording::read_trace_file(recording.path);
    recording::Trace trace = recording::read_trace(text, recording.path, recording.format, limits);
    recording.sha256 = copies.recording ? "" : sha256(text);
    recording.played_text = std::move(trace.text);
    recording.voltage_at = std::move(trace.voltage_at);
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
std::string option_name(const std::string& of_key) {
  std::string key = of_key;
  constexpr const char* kUnits[] = {"_s", "_hz"};
  for (const std::string unit : kUnits) {
    if (key.size() > unit.size() && key.compare(key.size() - unit.size(), unit.size(), unit) == 0) {
      key.resize(key.size() - unit.size());
    }
  }
  std::replace(key.begin(), key.end(), '_', '-');
  return "--trace-" + key;
}

// Why it is not read: a pipe might never end.
const char* not_a_file(const std::string& path) {
  std::error_code ignored;  // then there is no such file for this user
  return std::filesystem::exists(path, ignored)
             ? "is a folder, device or pipe; save the recording as an ordinary file"
             : "does not exist";
}

}  // namespace

void read_trace_section(const Table& signal, double nominal_hz, const Copies& copies,
                        Stimulus& stimulus) {
  const Table table = signal.table("trace");
  const std::string file = table.text("file");
  Recording recording;
  recording.file = file;
  recording.path = resolve(file, table.document().path);
  recording.format = read_trace_format(table);
  if (!copies.recording && !is_regular_file(recording.path)) {
    table.refuse("file", fmt::format("file is \"{}\"; {} {}", file, recording.path,
                                     not_a_file(recording.path)));
  }
  try {
    recording::TraceLimits limits = limits_of(nominal_hz);
    limits.duration_s = signal.find_number("duration_s").value_or(limits.duration_s);
    use(std::move(recording), limits, copies, stimulus);
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
        "--trace requires --trace-time and --trace-frequency, the names of the columns, or their "
        "numbers from 1");
  }
  if (!copies.recording && !is_regular_file(recording.path)) {
    throw ConfigurationError(recording.path + ": " + not_a_file(recording.path));
  }
  stimulus.losses.clear();
  stimulus.initial_deviation_hz = 0.0;
  stimulus.oscillations.clear();
  stimulus.signal.amplitude_steps.clear();
  stimulus.signal.phase_jumps.clear();
  stimulus.signal.tones.clear();
  stimulus.signal.flickers.clear();
  try {
    recording::TraceLimits limits = limits_of(nominal_hz);
    limits.option_name = option_name;
    use(std::move(recording), limits, copies, stimulus);
  } catch (const recording::FormatError& error) {
    // The message starts with the key if it is about its value.
    const std::string what = error.what();
    const std::string option = option_name(error.key);
    throw ConfigurationError(what.rfind(error.key + ' ', 0) == 0
                                 ? option + what.substr(error.key.size())
                                 : option + ": " + what);
  }
}

}  // namespace gsbench::profile
