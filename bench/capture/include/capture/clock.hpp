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

// A dip of the voltage to `level` of its amplitude, from one tick to another of the run.
struct Dip {
  std::int64_t from_tick = 0;
  std::int64_t to_tick = 0;
};

struct Markers {
  double level = 0.7;
  std::vector<Dip> before;  // ascending
  std::vector<Dip> after;   // none where the run was ended early
};

// What an outlet said of its voltage, by its own stamps.
struct VoltageTrace {
  std::vector<std::uint64_t> sample;  // ascending
  std::vector<float> voltage_pu;
  double delay_samples = 0.0;  // a voltage is that of so long before its stamp
};

struct Alignment {
  OutletClock clock;
  record::Clock told;
};

// Least squares over the dips' middles. Without those after the run the drift is taken as 0 with
// the uncertainty of a crystal of ±100 ppm. Nothing where the dips before the run are not found:
// they are told by their spacing, which no two neighbours share.
std::optional<Alignment> align(const VoltageTrace& trace, const Markers& markers,
                               double sample_rate_hz);

}  // namespace gsbench::capture
