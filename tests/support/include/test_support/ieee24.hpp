// The paper's grid, as shipped.
#pragma once

#include <profile/load.hpp>

namespace gsbench::test {

inline const grid::Grid& ieee24() {
  static const grid::Grid grid = profile::load_grid("ieee24");
  return grid;
}

}  // namespace gsbench::test
