// What is played: [signal], and [[grid.loss]].
#pragma once

#include "table.hpp"

#include <grid/grid.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

// `skip_recording`: another recording is going to take the place of [signal.trace], whose file need
// not be there then.
Stimulus read_stimulus(const Table& signal, const Table& grid_section, const grid::Grid& grid,
                       bool skip_recording);

// Of every source, per unit of the nominal amplitude (peak).
constexpr double kFullScale_pu = 1.5;

// Refuses what a source could not play. Noise is not counted: an outlet's input clips it.
void check_full_scale(const Table& signal, const Stimulus& stimulus, const waveform::Truth& truth);

}  // namespace gsbench::profile
