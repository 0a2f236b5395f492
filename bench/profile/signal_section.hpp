// What is played: [signal], and [[grid.loss]].
#pragma once

#include <grid/grid.hpp>
#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

keys::Key signal_keys();

// `skip_recording`: another recording is going to take the place of [signal.trace], whose file need
// not be there then.
Stimulus read_stimulus(const keys::Table& signal, const keys::Table& grid_section,
                       const grid::Grid& grid, bool skip_recording);

}  // namespace gsbench::profile
