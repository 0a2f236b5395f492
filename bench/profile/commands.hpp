// [[command]]: what the control centre orders during the run.
#pragma once

#include <vector>

#include <keys/table.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

keys::Key command_keys();

std::vector<Command> read_commands(const keys::Table& top, const std::vector<Outlet>& outlets,
                                   double duration_s);

}  // namespace gsbench::profile
