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
  // One for each outlet of the run, all with the same decimals. "–": no value; "?" at the end: an
  // estimate that the outlet flagged as unreliable when it decided.
  std::vector<std::string> cells;

  std::string heading_in_one_line() const;  // "Event after, ms"
};

// Measures for which any outlet has a value, most important first, at most `most`.
std::vector<KeyColumn> key_columns(const record::RunRecord& run, std::size_t most);

// Explanation of "?" in cells; empty if there is none.
std::string doubt_note(const record::RunRecord& run);

}  // namespace gsbench::render
