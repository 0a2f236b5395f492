// The noise of the measured phases, for grid_follower.cpp.
#pragma once

#include <outlet/grid_follower.hpp>

namespace gs::outlet {

// GridFollower::noise_squares of the phase noise in the settings.
float nominal_noise_squares(const FollowerSettings& settings);

// Variance of a measured phase at nominal amplitude, cycles²: the larger of the setting's and the
// measured one.
float phase_variance(const FollowerSettings& settings, const GridFollower& follower);

// Updates noise_squares with the newest report. Requires four successive measurements.
void measure_noise(GridFollower& follower);

}  // namespace gs::outlet
