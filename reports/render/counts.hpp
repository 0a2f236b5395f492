// How many outlets of a run have which verdict, for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <render/view.hpp>

namespace gsbench::render {

constexpr std::size_t kMostIdColumns = 40;  // longer ids are shortened in the middle

// On one line, without control characters.
std::string one_line(const std::string& text);

// A table with a row for each group, those with most outlets that did not pass first, and one for
// all outlets. With more groups than `most_groups`, the row for all only. Verdicts that no outlet
// has are left out.
std::vector<std::string> count_table(const View& view, std::size_t most_groups);

}  // namespace gsbench::render
