// Recordings of the mains: points of frequency and voltage, from CSV.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gsbench::recording {

struct TracePoint {
  double t_s;  // from the first point
  double frequency_hz;
  double voltage_pu = 1.0;  // 1 if the recording has no voltage
};

// How a CSV recording is read, and which part of it is played.
struct TraceFormat {
  // Columns: the name in the header, or the number from 1. A name has precedence; "#2" is a number.
  std::string time;
  std::string frequency;
  std::string voltage;  // empty: none
  // In the column's unit (RMS), above 0; nullopt: median of the played part.
  std::optional<double> nominal_voltage = std::nullopt;

  // The window: seconds after the first row that has a time, or date and time as in the recording.
  std::string from = {};   // empty: from the first row
  std::string until = {};  // empty: to the last row

  std::string delimiter = {};    // a character, "tab" or "space"; empty: "," or ";", see decimal
  std::string decimal = ".";     // "." or ","; with "," the default of the delimiter is ";"
  double skip_rows = 0;          // lines above the header; whole, at least 0
  double header_rows = 1;        // whole, at least 0; names are in the first of them
  std::string time_unit = "s";   // of times that are numbers: kTimeUnits
  std::string time_format = {};  // as strptime, see kTimeDirectives; empty: see read_trace()
  std::string frequency_unit = "Hz";   // kFrequencyUnits
  double frequency_offset_hz = 0;      // is added: 50 for deviations from 50 Hz
  std::vector<std::string> gaps = {};  // further words for a missing value
};

constexpr const char* kTimeUnits[] = {"s", "ms", "us", "ns", "min", "h", "d"};
constexpr const char* kFrequencyUnits[] = {"Hz", "mHz", "kHz", "rad/s", "pu"};
// Year, month, day, name of the month, hour, hour of 12 with AM or PM, minute, second with
// decimals, offset from UTC.
constexpr const char* kTimeDirectives = "%Y %y %m %d %b %H %I %p %M %S %z %%";

// A name and the field of every option, in the order of the documentation.
template <class Format, class Visitor>
void visit_fields(Format& format, Visitor&& visitor) {
  visitor("time", format.time);
  visitor("frequency", format.frequency);
  visitor("voltage", format.voltage);
  visitor("nominal_voltage", format.nominal_voltage);
  visitor("from_s", format.from);
  visitor("until_s", format.until);
  visitor("delimiter", format.delimiter);
  visitor("decimal", format.decimal);
  visitor("skip_rows", format.skip_rows);
  visitor("header_rows", format.header_rows);
  visitor("time_unit", format.time_unit);
  visitor("time_format", format.time_format);
  visitor("frequency_unit", format.frequency_unit);
  visitor("frequency_offset_hz", format.frequency_offset_hz);
  visitor("gaps", format.gaps);
}

// What the played part must satisfy.
struct TraceLimits {
  double nominal_hz = 50.0;  // for frequencies in p.u.
  double lowest_hz = 0.0;
  double highest_hz = std::numeric_limits<double>::infinity();
  double shortest_s = 0.0;
  double longest_s = std::numeric_limits<double>::infinity();
  // Time to play. Rows after the first point at or beyond it are not read.
  double duration_s = std::numeric_limits<double>::infinity();
  // How messages name an option that they advise, by its name in visit_fields(); nullptr: so.
  std::string (*option_name)(const std::string& name) = nullptr;
};

struct Place {
  std::size_t line = 1;    // from 1
  std::size_t column = 1;  // in bytes, from 1
};

// The played part of a recording.
struct Trace {
  std::vector<TracePoint> points;  // at least two, ascending; the first is at 0
  std::vector<Place> voltage_at;   // of the voltage of each point; empty without a voltage column
  std::size_t rows = 0;            // with gaps
  std::size_t gaps = 0;            // rows without a time, frequency or voltage
  // A CSV with the lines above the data, the rows of the played part, and the first row, if `from`
  // or `until` depends on it. Read with the same format and limits, it gives the same points, bit
  // for bit.
  std::string text;
};

// A bad option of a TraceFormat. `key`: its name in visit_fields(); empty: none in particular.
struct FormatError : std::runtime_error {
  FormatError(std::string the_key, const std::string& what)
      : std::runtime_error(what), key(std::move(the_key)) {}

  std::string key;
};

// Reads a CSV recording. Without a time_format, times are numbers, or date and time of day such as
// `28-Apr-2025 11:00:02`, `2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`. A row with an empty
// time, frequency or voltage, or `NaN`, `-NaN`, `NA`, `N/A` or `null` in any case, is a gap and
// gives no point. A time that is valid is none of the words of `gaps`.
//
// Rows outside the window and after the duration may have any content. Throws FormatError, or
// std::runtime_error with `path:line:column: …` if a column, or a row, value or time of the played
// part, is not valid.
Trace read_trace(const std::string& text, const std::string& path, const TraceFormat& format,
                 const TraceLimits& limits = {});

// True if the bytes are valid UTF-8.
bool is_utf8(std::string_view bytes);

// The bytes of a file. Throws std::runtime_error with `path:1:1: …` if it cannot be read.
std::string read_trace_file(const std::string& path);

}  // namespace gsbench::recording
