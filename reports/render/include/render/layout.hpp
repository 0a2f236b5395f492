// Layout of text for terminals: lines of at most kLineColumns, aligned tables.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gsbench::render {

constexpr std::size_t kLineColumns = 100;

// Columns on a terminal. Each code point counts as one: nothing wider is printed.
std::size_t columns_of(const std::string& text);

// `text` broken at spaces into lines of at most `columns`, without a line end after the last. All
// lines but the first start with `indent` spaces. A word longer than a line (a path, a digest) is
// not broken; line ends in `text` are kept.
std::string wrapped(const std::string& text, std::size_t columns = kLineColumns,
                    std::size_t indent = 0);

// True if no line has more than kLineColumns.
bool fit(const std::vector<std::string>& lines);

// `text` in at most `columns` (at least 1): what does not fit is replaced by "…" in the middle.
std::string shortened(const std::string& text, std::size_t columns);
// The same with "…" at the end.
std::string beginning(const std::string& text, std::size_t columns);

// One line per row, two spaces between columns, no spaces at the end of a line. `sides` has 'l'
// (left) or 'r' (right) for each column; its last letter holds for all further columns. Rows may
// differ in length.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows,
                                 const std::string& sides = "lr");

}  // namespace gsbench::render
