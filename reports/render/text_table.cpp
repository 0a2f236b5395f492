#include "text_table.hpp"

#include "format.hpp"

#include <algorithm>
#include <sstream>

namespace gsbench::render {
namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<Cells>;

constexpr std::size_t kGap = 2;          // columns between two cells
constexpr std::size_t kNarrowName = 36;  // row names are not broken into lines shorter than that
constexpr std::size_t kNameIndent = 2;   // of a row name's further lines
constexpr std::size_t kMostHeadingLines = 3;

Cells lines_of(const std::string& text) {
  Cells lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines.empty() ? Cells{""} : lines;
}

std::size_t widest(const Cells& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) {
    width = std::max(width, columns_of(line));
  }
  return width;
}

// The narrowest form of a heading that has at most that many lines.
Cells heading_in(const std::string& heading, std::size_t most_lines) {
  for (std::size_t width = 1;; ++width) {
    Cells lines = lines_of(wrapped(heading, width));
    if (lines.size() <= most_lines) {
      return lines;
    }
  }
}

std::vector<Cells> headings_in(const Cells& headings, std::size_t most_lines) {
  std::vector<Cells> all;
  for (const std::string& heading : headings) {
    all.push_back(heading_in(heading, most_lines));
  }
  return all;
}

// Of each column; a row may have fewer cells than there are headings.
std::vector<std::size_t> widths_of(const std::vector<Cells>& headings, const Rows& rows) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    widths.push_back(widest(headings[i]));
    for (std::size_t row = 1; row < rows.size(); ++row) {
      widths[i] = std::max(widths[i], i < rows[row].size() ? columns_of(rows[row][i]) : 0);
    }
  }
  return widths;
}

// Of columns 1 … count, with the gaps before them.
std::size_t figures_width(const std::vector<std::size_t>& widths, std::size_t count) {
  std::size_t sum = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    sum += kGap + widths[i];
  }
  return sum;
}

void pad(std::string& line, std::size_t columns) {
  const std::size_t used = columns_of(line);
  line.append(columns > used ? columns - used : 0, ' ');
}

// Figures stand on the last line of a row's name.
void append_row(const Cells& name, const Cells& row, const std::vector<std::size_t>& widths,
                Cells& lines) {
  lines.insert(lines.end(), name.begin(), name.end());
  std::string& line = lines.back();
  std::size_t end = widths[0];
  for (std::size_t i = 1; i < std::min(row.size(), widths.size()); ++i) {
    end += kGap + widths[i];
    if (row[i].empty()) {
      continue;  // no spaces at the end of a line
    }
    pad(line, end - columns_of(row[i]));
    line += row[i];
  }
}

// The columns that row names take if they are broken into lines of at most `most`.
std::size_t name_width(const Cells& heading, const Rows& rows, std::size_t most) {
  std::size_t width = widest(heading);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    width = std::max(width, widest(lines_of(wrapped(rows[row][0], most, kNameIndent))));
  }
  return width;
}

Cells lines_in(const std::vector<Cells>& headings, const std::vector<std::size_t>& widths,
               const Rows& rows) {
  std::size_t heading_lines = 0;
  for (const Cells& heading : headings) {
    heading_lines = std::max(heading_lines, heading.size());
  }
  Cells lines;
  for (std::size_t line = 0; line < heading_lines; ++line) {
    Cells cells;  // of headings that all end on the last line
    for (const Cells& heading : headings) {
      const std::size_t above = heading_lines - heading.size();
      cells.push_back(line < above ? "" : heading[line - above]);
    }
    append_row({cells[0]}, cells, widths, lines);
  }
  for (std::size_t row = 1; row < rows.size(); ++row) {
    append_row(lines_of(wrapped(rows[row][0], widths[0], kNameIndent)), rows[row], widths, lines);
  }
  return lines;
}

// Those cells of each row and, before them, the row's name.
Rows part_of(const Rows& rows, std::size_t first, std::size_t end) {
  Rows part;
  for (const Cells& row : rows) {
    part.push_back({row[0]});
    for (std::size_t i = first; i < std::min(end, row.size()); ++i) {
      part.back().push_back(row[i]);
    }
  }
  return part;
}

}  // namespace

std::vector<std::string> table_lines(const Rows& rows, std::size_t columns) {
  const std::size_t figures = rows[0].size() - 1;
  for (std::size_t most_lines = 1; most_lines <= kMostHeadingLines; ++most_lines) {
    const std::vector<Cells> headings = headings_in(rows[0], most_lines);
    std::vector<std::size_t> widths = widths_of(headings, rows);
    const std::size_t taken = figures_width(widths, figures);
    const std::size_t for_name = columns > taken ? columns - taken : 0;
    if (widths[0] <= for_name || (most_lines > 1 && for_name >= kNarrowName)) {
      widths[0] = name_width(headings[0], rows, std::min(widths[0], for_name));
      return lines_in(headings, widths, rows);
    }
  }
  // The widest part that fits, then the others.
  const std::vector<std::size_t> widths = widths_of(headings_in(rows[0], kMostHeadingLines), rows);
  const std::size_t for_figures = columns - std::min(columns, std::min(widths[0], kNarrowName));
  std::size_t fit = 1;
  while (fit < figures && figures_width(widths, fit + 1) <= for_figures) {
    ++fit;
  }
  if (fit >= figures) {  // a single column, wider than a line: it stays so
    return aligned(rows);
  }
  Cells lines = table_lines(part_of(rows, 1, fit + 1), columns);
  const Cells others = table_lines(part_of(rows, fit + 1, figures + 1), columns);
  lines.insert(lines.end(), others.begin(), others.end());
  return lines;
}

}  // namespace gsbench::render
