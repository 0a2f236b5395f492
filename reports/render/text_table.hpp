// Tables for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gsbench::render {

// The lines of a table, none wider than `columns`. `rows`: cells, the headings first; the first
// cell of a row is its name, aligned left, the others are figures, aligned right. A table that is
// too wide gets headings of two or three lines and row names of several, each broken at words; if
// that is not enough, its columns are printed in several parts below one another.
std::vector<std::string> table_lines(const std::vector<std::vector<std::string>>& rows,
                                     std::size_t columns);

}  // namespace gsbench::render
