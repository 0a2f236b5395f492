// Finds the marker dips in an outlet's voltage trace. The error is at most one interval between
// readings: 16 ms if no reading is lost. align() (capture/clock.hpp) starts its fit from these
// dips.
#pragma once

#include <vector>

#include <capture/clock.hpp>

namespace gsbench::capture {

// The middle of a marker dip: in ticks of the run and in samples of the outlet.
struct FoundMarker {
  double tick = 0.0;
  double sample = 0.0;
};

struct FoundMarkers {
  std::vector<FoundMarker> markers;  // empty: the markers before the run were not found
  bool after = false;                // true: includes the markers after the run
};

// The square of the voltage that is half way between nominal and a dip's level, by V², p.u.². The
// RMS² of a window crosses it half a window after the voltage.
double edge_square(double level);

FoundMarkers find_markers(const VoltageTrace& trace, const Markers& markers, double sample_rate_hz);

}  // namespace gsbench::capture
