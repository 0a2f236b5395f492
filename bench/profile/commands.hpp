// [[command]]: what the control centre orders during the run.
#pragma once

#include "table.hpp"

#include <vector>

#include <profile/plan.hpp>

namespace gsbench::profile {

std::vector<Command> read_commands(const Table& top, const std::vector<Outlet>& outlets,
                                   double duration_s);

}  // namespace gsbench::profile
