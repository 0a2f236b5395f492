// The catalogue of measures: what a profile can set limits to, as `gsbench measures` prints it.
// For each measure, bench/judge has one function, which reads the value from a record.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::measures {

struct Measure {
  std::string name;
  std::string unit;        // empty for a plain number or a text
  std::string definition;  // one or two sentences
  std::string needs;       // what must be there for a value; "nothing" if there always is one
  std::vector<std::string> text_values = {};  // the possible values; empty if it is a number

  bool is_text() const { return !text_values.empty(); }
};

const std::vector<Measure>& catalogue();

// nullptr for an unknown name.
const Measure* find(const std::string& name);

// The factor by which a value in `from` is multiplied to give the value in `to`. No value if a unit
// is unknown or the dimensions differ. The empty unit is that of plain numbers.
std::optional<double> unit_scale(const std::string& from, const std::string& to);

// All units of the same dimension, `unit` included; empty for an unknown unit.
std::vector<std::string> units_like(const std::string& unit);

}  // namespace gsbench::measures
