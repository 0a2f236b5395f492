// [[expect]]: the limits that a run is judged by.
#pragma once

#include <vector>

#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

keys::Key expect_keys();

std::vector<Expectation> read_expectations(const keys::Table& top,
                                           const std::vector<Outlet>& outlets);

}  // namespace gsbench::profile
