#include "columns.hpp"

#include "shown.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace gsbench::recording {
namespace {

// The first ten, and how many there are.
std::string column_list(const std::vector<Cell>& header) {
  constexpr std::size_t kMostListed = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(header.size(), kMostListed); ++i) {
    list += (i == 0 ? "`" : ", `") + shown(header[i].text) + '`';
  }
  return header.size() > kMostListed ? list + fmt::format(", … ({} in all)", header.size()) : list;
}

std::string delimiter_name(char delimiter) {
  return delimiter == '\t' ? "tab" : std::string(1, delimiter);
}

// "3" and "#3" as 3.
std::optional<std::size_t> column_number(const std::string& column) {
  const std::size_t first = column.rfind('#', 0) == 0 ? 1 : 0;
  const std::string digits = column.substr(first);
  constexpr std::size_t kMostDigits = 6;
  if (digits.empty() || digits.size() > kMostDigits ||
      digits.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  return std::stoul(digits);
}

}  // namespace

std::size_t column_of(const char* key, const std::string& column, const std::vector<Cell>& header,
                      const std::string& advice) {
  const auto is_it = [&](const Cell& cell) { return cell.text == column; };
  const auto found = std::find_if(header.begin(), header.end(), is_it);
  if (found != header.end()) {
    const auto again = std::find_if(found + 1, header.end(), is_it);
    if (again != header.end()) {
      throw CsvError(again->place, fmt::format("a second column `{}`; the name must be unique, or "
                                               "give the column's number",
                                               shown(column)));
    }
    return static_cast<std::size_t>(found - header.begin());
  }
  const std::optional<std::size_t> number = column_number(column);
  if (header.empty()) {
    if (!number || *number == 0) {
      throw FormatError(key, fmt::format("{} is `{}`; without a header it must be the number of a "
                                         "column, from 1",
                                         key, shown(column)));
    }
    return *number - 1;
  }
  if (!number || *number == 0 || *number > header.size()) {
    const std::string& first = header.front().text;
    const std::size_t other = first.find_first_of(";\t|");
    const bool other_delimiter = header.size() == 1 && other != std::string::npos;
    throw CsvError(
        header.front().place,
        fmt::format("no column `{}`; the columns are {}{}; {}", shown(column), column_list(header),
                    other_delimiter
                        ? fmt::format(" (is the delimiter `{}`?)", delimiter_name(first[other]))
                        : "",
                    advice));
  }
  return *number - 1;
}

}  // namespace gsbench::recording
