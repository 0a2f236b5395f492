// The frequency that is played, as an exact function of time. Everything measured is compared with
// this and with nothing else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::waveform {

class Truth {
 public:
  virtual ~Truth() = default;
  virtual double nominal_hz() const = 0;
  virtual double frequency_hz(double t_s) const = 0;
  virtual double rocof_hz_s(double t_s) const = 0;
  // ∫ (f − nominal) dt from t = 0, in cycles; exact, so that phase never drifts.
  virtual double excess_cycles(double t_s) const = 0;
  // Amplitude that the recording itself prescribes, per unit of nominal; 1 where it prescribes
  // none. Continuous, and linear between corners.
  virtual double voltage_pu(double t_s) const = 0;
  // Times at which f or one of its derivatives jumps, ascending: interpolation must not reach
  // across them. f itself is continuous; rocof_hz_s at a corner is the right-hand limit.
  virtual std::vector<double> corners_s() const = 0;
};

struct FrequencyPoint {
  double t_s;
  double frequency_hz;
};

struct TracePoint {
  double t_s;  // from the start of the recording
  double frequency_hz;
  double voltage_pu;  // 1 where the recording has none
};

// Which columns of a CSV recording to read. `time` may hold seconds, or a date and time of day.
struct TraceColumns {
  std::string time;
  std::string frequency;
  std::string voltage;           // empty: none
  double nominal_voltage = 0.0;  // in the column's unit (RMS); 0: the median of the column
};

// A negative time in a loss list is a loss before the start: phase still counts from t = 0.
std::unique_ptr<Truth> truth_from_losses(grid::SfrModel model,
                                         std::vector<grid::PowerChange> losses);

// Monotone cubic interpolation (Fritsch–Carlson, with the slopes of Fritsch and Butland as in
// MATLAB's and SciPy's pchip): it passes through each point and overshoots none. Held constant
// before the first and after the last. Throws std::invalid_argument where there is no point, times
// do not ascend, or a value is not finite and positive; a voltage may be zero, and is interpolated
// linearly.
std::unique_ptr<Truth> truth_from_points(double nominal_hz,
                                         const std::vector<FrequencyPoint>& points);
std::unique_ptr<Truth> truth_from_trace(double nominal_hz, std::vector<TracePoint> points);

// Reads a CSV recording whose first row names the columns. Time is plain seconds, or a date and
// time such as `28-Apr-2025 11:00:02`, `2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`; the first
// row is t = 0. A row whose frequency or voltage is `NaN` is a gap of the recording and gives no
// point. Throws std::runtime_error with `file:line:column: …` on anything amiss: no such file, no
// such column, a row too short, a value that is no number, time that runs back.
std::vector<TracePoint> read_trace(const std::string& path, const TraceColumns& columns);

}  // namespace gsbench::waveform
