// A grid from a file of its own, or in place in a profile.
#pragma once

#include <string>

#include <grid/grid.hpp>
#include <keys/table.hpp>
#include <profile/files.hpp>

namespace gsbench::profile {

keys::Key grid_section_keys();  // [grid]

grid::Grid read_grid_file(const NamedFile& file);

// The grid that a profile's [grid] names or holds; `title` and `source` are the profile's, for one
// that it holds.
grid::Grid read_grid_section(const keys::Table& section, const std::string& title,
                             const std::string& source);

// Refuses a grid that asks for more load-shedding conditions than outlets keep; on its own such a
// grid is fine.
void check_conditions(const keys::Table& section, const grid::Grid& grid);

}  // namespace gsbench::profile
