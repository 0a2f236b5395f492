// Recordings of the mains as points of frequency and voltage.
#pragma once

#include <string>
#include <vector>

namespace gsbench::recording {

struct TracePoint {
  double t_s;  // from the start of the recording
  double frequency_hz;
  double voltage_pu = 1.0;  // where the recording has none
};

// Which columns of a CSV recording to read. `time` may hold seconds, or a date and time of day.
struct TraceColumns {
  std::string time;
  std::string frequency;
  std::string voltage;           // empty: none
  double nominal_voltage = 0.0;  // in the column's unit (RMS); 0: the median of the column
};

// Reads a CSV recording whose first row names the columns. Time is plain seconds, or a date and
// time such as `28-Apr-2025 11:00:02`, `2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`; the first
// row is t = 0. A row whose frequency or voltage is `NaN` is a gap of the recording and gives no
// point. Throws std::runtime_error with `file:line:column: …` on anything amiss: no such file, no
// such column, a row too short, a value that is no number, time that runs back.
std::vector<TracePoint> read_trace(const std::string& path, const TraceColumns& columns);

}  // namespace gsbench::recording
