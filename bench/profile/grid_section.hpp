// A grid from a file of its own, or in place in a profile.
#pragma once

#include "files.hpp"
#include "table.hpp"

#include <string>

#include <grid/grid.hpp>

namespace gsbench::profile {

grid::Grid read_grid_file(const NamedFile& file);

// The grid that a profile's [grid] names or holds; `title` and `source` are the profile's, for one
// that it holds.
grid::Grid read_grid_section(const Table& section, const std::string& title,
                             const std::string& source);

}  // namespace gsbench::profile
