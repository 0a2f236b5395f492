// What the files may say: every key of a profile and of a grid, with unit, range and default.
#pragma once

#include <keys/key.hpp>

namespace gsbench::profile {

const keys::Key& profile_keys();
const keys::Key& grid_keys();

}  // namespace gsbench::profile
