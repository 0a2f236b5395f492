// The control that other controls are measured against: it knows the state of the grid at once, a
// loss T after it happens and a return of power at once.
#pragma once

#include <vector>

#include <fleet/grid_state.hpp>

namespace gsbench::fleet {

// Where the goal is out of reach, the clairvoyant sheds what keeps the nadir within this of the
// best: the last bit would cost all load that there is.
constexpr double kWithinBest_hz = 0.01;
constexpr double kLeastAction_mw = 0.05;  // less is not shed

// The least power to be shed at once so that the lowest deviation from now on is goal_hz or, if
// that is above it, kWithinBest_hz below the best that shedding all of available_mw can reach. No
// more than the lost power is shed. 0 if nothing need be shed. `state` has the lost power as known.
double least_shed_mw(const grid::SfrModel& model, const GridState& state, double goal_hz,
                     double available_mw);

double lost_mw(const std::vector<grid::PowerChange>& losses, double t_s);

// Lost power as known with a delay: the least of [t_s − delay_s, t_s], MW. So a loss is known
// delay_s after it happens, and a return at once.
double known_loss_mw(const std::vector<grid::PowerChange>& losses, double t_s, double delay_s);

}  // namespace gsbench::fleet
