// An outlet counts its own samples, on a crystal some ppm off, from a beginning of its own. Dips of
// the voltage at known ticks before and after what is judged tell the bench when its counts are: no
// latency of source or link enters, since the outlet stamps the dips as it stamps all else.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::capture {

// An outlet's sample count as ticks of the run: a straight line.
class OutletClock {
 public:
  // Counts the very ticks of the run.
  OutletClock() = default;
  OutletClock(double sample_at_zero, double samples_per_tick)
      : sample_at_zero_(sample_at_zero), samples_per_tick_(samples_per_tick) {}

  std::int64_t tick_of(std::uint64_t sample) const;

 private:
  double sample_at_zero_ = 0.0;
  double samples_per_tick_ = 1.0;
};

// A dip of the voltage, from one tick to another of the run.
struct Dip {
  std::int64_t from_tick = 0;
  std::int64_t to_tick = 0;
};

// Calm mains with dips, and what was played there.
struct MarkedStretch {
  std::int64_t first_tick = 0;
  std::vector<Dip> dips;           // ascending
  std::vector<double> square_sum;  // of the samples before each tick from first_tick on, pu²
};

struct Markers {
  double level = 0.7;  // of the amplitude, in each dip
  MarkedStretch before;
  MarkedStretch after;
};

// What an outlet said of its voltage, by its own stamps.
struct VoltageTrace {
  std::vector<std::uint64_t> sample;  // ascending
  std::vector<float> voltage_pu;
  double window_samples = 0.0;  // each is the RMS of so much before its stamp
};

struct Alignment {
  OutletClock clock;
  record::Clock told;
};

// The line on which the outlet's readings in the dips' flanks come nearest to the RMS of what was
// played, by least squares. Where the dips after the run are not seen the drift is taken as 0 with
// the uncertainty of a crystal of ±100 ppm. Nothing where those before it are not seen: they are
// told by their spacing, which no two neighbours share.
std::optional<Alignment> align(const VoltageTrace& trace, const Markers& markers,
                               double sample_rate_hz);

}  // namespace gsbench::capture
