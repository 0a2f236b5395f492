// [[outlet]]: who listens, and with which settings.
#pragma once

#include "table.hpp"

#include <vector>

#include <grid/grid.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

std::vector<Outlet> read_outlets(const Table& top, const grid::Grid& grid);

}  // namespace gsbench::profile
