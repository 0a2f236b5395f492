// What a source can play.
#pragma once

#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

// Of every source, per unit of the nominal amplitude (peak).
constexpr double kFullScale_pu = 1.5;

// Refuses what a source could not play. Noise is not counted: an outlet's input clips it.
void check_full_scale(const keys::Table& signal, const Stimulus& stimulus,
                      const waveform::Truth& truth);

}  // namespace gsbench::profile
