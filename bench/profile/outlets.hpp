// [[outlet]]: who listens, and with which settings.
#pragma once

#include <vector>

#include <grid/grid.hpp>
#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

keys::Key outlet_keys();

std::vector<Outlet> read_outlets(const keys::Table& top, const grid::Grid& grid);

}  // namespace gsbench::profile
