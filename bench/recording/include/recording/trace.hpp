// Recordings of the mains: points of frequency and voltage.
#pragma once

#include <string>
#include <vector>

namespace gsbench::recording {

struct TracePoint {
  double t_s;  // from the start of the recording
  double frequency_hz;
  double voltage_pu = 1.0;  // 1 if the recording has no voltage
};

// Names of the columns of a CSV recording.
struct TraceColumns {
  std::string time;
  std::string frequency;
  std::string voltage;           // empty: none
  double nominal_voltage = 0.0;  // in the column's unit (RMS); 0: the column's median is nominal
};

// Reads a CSV recording whose first row has the names of the columns. Times are in seconds, or date
// and time of day such as `28-Apr-2025 11:00:02`, `2025-04-28 11:00:02.5` or
// `2025-04-28T11:00:02Z`. The first row of values is at t = 0. A row with frequency or voltage
// `NaN` is a gap and gives no point. Throws std::runtime_error with `file:line:column: …` if the
// file cannot be read, or a column, row, value or time in it is not valid.
std::vector<TracePoint> read_trace(const std::string& path, const TraceColumns& columns);

}  // namespace gsbench::recording
