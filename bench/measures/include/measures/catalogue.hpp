// The catalogue of measures. A measure is a quantity that a profile can set limits to. `gsbench
// measures` prints the catalogue. For each measure, bench/judge has one function, which reads the
// value from a record.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::measures {

struct Measure {
  std::string name;
  std::string unit;        // empty for a plain number or a text
  std::string definition;  // one or two sentences
  std::string needs;       // condition for having a value; "nothing" if it always has one
  std::vector<std::string> text_values = {};  // the possible texts; empty for a number
  // True if the outlet must have a link: it reports what is measured, or is sent a command. False
  // if the relay sense suffices.
  bool needs_link = true;

  bool is_text() const { return !text_values.empty(); }
};

const std::vector<Measure>& catalogue();

// Names of the measures that need no link, for messages.
std::vector<std::string> measured_by_contact();

// nullptr for an unknown name.
const Measure* find(const std::string& name);

// The factor by which a value in `from` is multiplied to give the value in `to`. No value if a unit
// is unknown or the dimensions differ. Plain numbers have the empty unit.
std::optional<double> unit_scale(const std::string& from, const std::string& to);

// All units of the same dimension, `unit` included; empty for an unknown unit.
std::vector<std::string> units_like(const std::string& unit);

}  // namespace gsbench::measures
