// What the outlet does with a measurement (§5.5), for outlet.cpp.
#pragma once

#include <outlet/outlet.hpp>

namespace gs::outlet {

// Detects, estimates and decides. `report` holds the measurement and the line; `z` is its phasor.
void act(const Config& config, State& state, const Phasor& z, Report& report);

}  // namespace gs::outlet
