// Alignment of an outlet's sample clock with the run. An outlet counts its samples from its own
// start-up, by its own crystal, which is some ppm off. The bench plays voltage dips at known ticks
// before and after the run and finds them in the outlet's voltage trace. The latency of source and
// link does not matter, since the outlet stamps the dips like all its reports.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::capture {

// A voltage dip, in ticks of the run.
struct Dip {
  std::int64_t from_tick = 0;
  std::int64_t to_tick = 0;
};

// Steady mains with dips before or after the run.
struct MarkedStretch {
  std::int64_t first_tick = 0;
  std::vector<Dip> dips;           // ascending
  std::vector<double> square_sum;  // element i: sum of i squared samples from first_tick on, p.u.²
};

struct Markers {
  double level = 0.7;  // amplitude in the dips, p.u.
  MarkedStretch before;
  MarkedStretch after;
};

// The voltage that an outlet reports, with its own time stamps.
struct VoltageTrace {
  std::vector<std::int64_t> sample;  // ascending
  std::vector<float> voltage_pu;
  double window_samples = 0.0;  // length of the RMS window that ends at the stamp
};

// Keeps what align() uses of the voltage that an outlet reports: the last reading, and those near
// an edge of a dip. So the memory grows with the number of dips, not with the length of the run.
class EdgeReadings {
 public:
  // `level` of the markers, `window_samples` of the outlet.
  EdgeReadings(double level, double window_samples);

  // The next readings, ascending; columns of equal length.
  void add(const std::vector<std::int64_t>& sample, const std::vector<float>& voltage_pu);
  VoltageTrace trace() const;

 private:
  struct Reading {
    std::int64_t sample;
    float voltage_pu;
  };
  void add(const Reading& reading);
  void keep(const Reading& reading);

  double threshold_;
  std::int64_t near_samples_;
  VoltageTrace kept_;
  std::deque<Reading> recent_;  // not kept, but near an edge that may follow
  std::optional<bool> was_below_;
  std::int64_t keeps_until_ = std::numeric_limits<std::int64_t>::min();
};

// Least-squares fit of offset and rate, so that the outlet's voltage in the edges of the dips
// matches the RMS of the played signal. Dips are identified by their length and spacing. Without
// the dips after the run, the drift is set to 0 and its uncertainty to that of a crystal of
// ±100 ppm. Returns nullopt if the dips before the run are not found or the fit fails.
std::optional<record::Clock> align(const VoltageTrace& trace, const Markers& markers,
                                   double sample_rate_hz);

}  // namespace gsbench::capture
