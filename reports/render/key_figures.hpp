// The few measurements that summarise what the outlets of a run did: one column per measure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

struct KeyColumn {
  std::string measure;               // of the catalogue
  std::vector<std::string> heading;  // in two lines: "Event", "after, ms"; the first may be empty
  // One for each outlet, all with the same decimals. "–": no value; "?" at the end: an
  // estimate that the outlet flagged as unreliable when it decided.
  std::vector<std::string> cells;

  std::string heading_in_one_line() const;  // "Event after, ms"
};

using Outlets = std::vector<const record::OutletRecord*>;
Outlets outlets_of(const record::RunRecord& run, const std::vector<std::size_t>& indices);

// Measures for which any of the outlets has a value, most important first, at most `most`.
std::vector<KeyColumn> key_columns(const Outlets& outlets, std::size_t most);

// Explanation of "?" in cells; empty if there is none.
std::string doubt_note(const Outlets& outlets);

}  // namespace gsbench::render
