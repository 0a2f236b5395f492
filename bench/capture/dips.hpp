// Markers in what an outlet says of its voltage, to within some milliseconds.
#pragma once

#include <vector>

#include <capture/clock.hpp>

namespace gsbench::capture {

// A marker's middle: by the run, and by the outlet.
struct MarkerSeen {
  double tick = 0.0;
  double sample = 0.0;
};

struct MarkersSeen {
  std::vector<MarkerSeen> markers;  // empty: those before the run are not there
  bool after = false;               // those after it are among them
};

MarkersSeen find_markers(const VoltageTrace& trace, const Markers& markers, double sample_rate_hz);

}  // namespace gsbench::capture
