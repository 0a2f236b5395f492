// Load-shedding conditions, §4.3, §5.2 and Table 1.
#pragma once

#include <outlet/history.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

// Does a line through the newest measurements meet the row that its middle falls into? Frequency
// and ROCOF must be of the same instant: the slope over a window held against the window's last
// frequency counts a loss below the threshold as one above it. Above the uppermost row none is met;
// below the lowest, f has passed f_s already and any further fall meets the condition.
bool condition_met(const Settings& settings, float nominal_hz, const Line& line);

}  // namespace gs::outlet
