#include <algorithm>
#include <array>

#include <measures/catalogue.hpp>

namespace gsbench::measures {
namespace {

struct Unit {
  const char* name;
  const char* dimension;
  double in_base;  // one of this unit, in the base unit of its dimension
};

constexpr std::array<Unit, 16> kUnits = {{
    {"", "number", 1.0},
    {"s", "time", 1.0},
    {"ms", "time", 1e-3},
    {"us", "time", 1e-6},
    {"Hz", "frequency", 1.0},
    {"mHz", "frequency", 1e-3},
    {"Hz/s", "rocof", 1.0},
    {"mHz/s", "rocof", 1e-3},
    {"MW", "power", 1.0},
    {"kW", "power", 1e-3},
    {"GW", "power", 1e3},
    {"%", "ratio", 1.0},
    {"ppm", "ratio", 1e-4},
    {"pu", "voltage", 1.0},
    {"V", "voltage in volts", 1.0},
    {"deg", "angle", 1.0},
}};

const Unit* find_unit(const std::string& name) {
  const auto* found = std::find_if(kUnits.begin(), kUnits.end(),
                                   [&](const Unit& unit) { return name == unit.name; });
  return found == kUnits.end() ? nullptr : found;
}

bool same_dimension(const Unit& a, const Unit& b) {
  return std::string(a.dimension) == b.dimension;
}

}  // namespace

std::optional<double> unit_scale(const std::string& from, const std::string& to) {
  const Unit* source = find_unit(from);
  const Unit* target = find_unit(to);
  if (source == nullptr || target == nullptr || !same_dimension(*source, *target)) {
    return std::nullopt;
  }
  return source->in_base / target->in_base;
}

std::vector<std::string> units_like(const std::string& unit) {
  std::vector<std::string> names;
  if (const Unit* known = find_unit(unit)) {
    for (const Unit& other : kUnits) {
      if (same_dimension(other, *known)) {
        names.emplace_back(other.name);
      }
    }
  }
  return names;
}

}  // namespace gsbench::measures
