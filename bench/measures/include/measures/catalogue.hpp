// What a profile can set limits to, as `gsbench measures` prints it: one row a measure. How each is
// read from a record is a row of bench/judge.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::measures {

struct Measure {
  std::string name;
  std::string unit;                     // empty: a plain number, or a word
  std::string definition;               // in a sentence
  std::string needs;                    // without which there is no value
  std::vector<std::string> words = {};  // not empty: it is one of these

  bool is_word() const { return !words.empty(); }
};

const std::vector<Measure>& catalogue();

// nullptr where there is no such measure.
const Measure* find(const std::string& name);

// x in `from` is x · unit_scale(from, to) in `to`; none where they are not of one dimension or
// either is unknown. The empty unit is that of plain numbers.
std::optional<double> unit_scale(const std::string& from, const std::string& to);

// All units of the dimension that `unit` is of; empty where it is unknown.
std::vector<std::string> units_like(const std::string& unit);

}  // namespace gsbench::measures
