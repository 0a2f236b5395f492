// What the outlet does with a measurement (§5.5), for outlet.cpp.
#pragma once

#include <outlet/outlet.hpp>

namespace gs::outlet {

// The frequency before an event. While the history does not cover it: that before a bridged gap of
// the voltage, otherwise the oldest of the history, which must not be empty then.
Baseline baseline(const State& state);

// Detects events, estimates the lost power, decides, and advances the relay. On entry `report`
// holds the measurement and the line; `z` is the phasor of the same report. Requires settings.
void act(const Config& config, State& state, const Phasor& z, Report& report);

}  // namespace gs::outlet
