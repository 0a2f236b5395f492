// Tables for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gsbench::render {

// The lines of a table, none wider than `columns`. The first of `rows` has the headings. The first
// cell of a row is its name, aligned left. The other cells are figures, aligned right. If the table
// is too wide, headings wrap to up to three lines and row names to several. If that is not enough,
// the columns are printed in several tables, one below the other.
std::vector<std::string> table_lines(const std::vector<std::vector<std::string>>& rows,
                                     std::size_t columns);

}  // namespace gsbench::render
