// Finds columns by name or number.
#pragma once

#include "csv.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gsbench::recording {

// Position of a column, from 0. Throws CsvError if it is not in the header, or FormatError if it is
// no number although there is no header. `header`: empty without one. `advice`: on another header.
std::size_t column_of(const char* key, const std::string& column, const std::vector<Cell>& header,
                      const std::string& advice);

}  // namespace gsbench::recording
