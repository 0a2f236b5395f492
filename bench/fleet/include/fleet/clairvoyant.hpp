// The best possible control, as a reference for the others. It knows the frequency and its slope
// without delay, a loss after a delay T, and a return of power without delay.
#pragma once

#include <vector>

#include <fleet/grid_state.hpp>

namespace gsbench::fleet {

// If the goal is out of reach, the clairvoyant keeps the nadir this far below the highest possible
// one. Otherwise it would shed all load for the last millihertz.
constexpr double kWithinBest_hz = 0.01;
constexpr double kLeastAction_mw = 0.05;  // less is not shed

// The least power, 0 … min(lost power, available_mw), that must be shed now to keep the lowest
// deviation from now on at goal_hz (a deviation, as in `state`). The goal is lowered to
// kWithinBest_hz below the deviation that shedding the most reaches, if it is above that. `state`:
// now, with the lost power as known.
double least_shed_mw(const grid::SfrModel& model, const GridState& state, double goal_hz,
                     double available_mw);

// Sum of the losses at t_s, with the completed part of ramps.
double lost_mw(const std::vector<grid::PowerChange>& losses, double t_s);

// Lost power as known at t_s: its minimum over [t_s − delay_s, t_s], MW. A loss is thus known
// delay_s after it happens, and a return at once.
double known_loss_mw(const std::vector<grid::PowerChange>& losses, double t_s, double delay_s);

}  // namespace gsbench::fleet
