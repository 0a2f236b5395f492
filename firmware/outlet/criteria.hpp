// What the outlet does with a measurement (§5.5), for outlet.cpp.
#pragma once

#include <outlet/outlet.hpp>

namespace gs::outlet {

// Detects events, estimates the lost power, decides, and advances the relay. On entry `report`
// holds the measurement and the line; `z` is the phasor of the same report. Requires settings.
void act(const Config& config, State& state, const Phasor& z, Report& report);

}  // namespace gs::outlet
