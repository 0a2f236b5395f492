// Columns of text on a terminal. A code point is one column: nothing wider is printed.
#pragma once

#include <string>
#include <vector>

namespace gsbench::render {

std::size_t columns_of(const std::string& text);

// A line for each row: the first cell aligned left, the others right, two spaces between. Rows may
// differ in length.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace gsbench::render
