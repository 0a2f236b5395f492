// Units of measurements, and what converts into what.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::measures {

// x in `from` is x · unit_scale(from, to) in `to`; none where they are not of one dimension or
// either is unknown. The empty unit is that of plain numbers.
std::optional<double> unit_scale(const std::string& from, const std::string& to);

// All units of the dimension that `unit` is of; empty where it is unknown.
std::vector<std::string> units_like(const std::string& unit);

}  // namespace gsbench::measures
