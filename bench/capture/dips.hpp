// Finds the marker dips in an outlet's voltage trace, to within one interval of its readings: 16 ms
// if none is lost. align() starts from them (capture/clock.hpp).
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

FoundMarkers find_markers(const VoltageTrace& trace, const Markers& markers, double sample_rate_hz);

}  // namespace gsbench::capture
