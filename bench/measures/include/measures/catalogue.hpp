// What a profile can set limits to, as `gsbench measures` prints it: one row a measure. How each is
// read from a record is a row of bench/judge.
#pragma once

#include <string>
#include <vector>

namespace gsbench::measures {

struct Measure {
  std::string name;
  std::string unit;                // empty: a plain number, or a word
  std::vector<std::string> words;  // not empty: it is one of these
  std::string definition;          // in a sentence
  std::string needs;               // without which there is no value

  bool is_word() const { return !words.empty(); }
};

const std::vector<Measure>& catalogue();

// nullptr where there is no such measure.
const Measure* find(const std::string& name);

}  // namespace gsbench::measures
