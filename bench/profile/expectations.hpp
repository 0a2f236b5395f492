// [[expect]]: the limits that a run is judged by.
#pragma once

#include "table.hpp"

#include <vector>

#include <profile/load.hpp>

namespace gsbench::profile {

std::vector<Expectation> read_expectations(const Table& top, const std::vector<Outlet>& outlets,
                                           const MeasureCatalogue& catalogue);

}  // namespace gsbench::profile
