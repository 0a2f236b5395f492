#include "sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <measures/catalogue.hpp>

namespace gsbench::profile {
namespace {

using keys::PlacedText;
using keys::Table;

const measures::Measure& find_measure(const Table& table, const std::string& name) {
  if (const measures::Measure* found = measures::find(name)) {
    return *found;
  }
  std::vector<std::string> names;
  for (const measures::Measure& known : measures::catalogue()) {
    names.push_back(known.name);
  }
  table.refuse("measure", fmt::format("unknown measure \"{}\"{}", name,
                                      keys::suggestion(name, names, "measures")));
}

std::string read_unit(const Table& table, const measures::Measure& measure) {
  std::string unit = table.find_text("unit").value_or("");
  if (measures::unit_scale(unit, measure.unit)) {
    return unit;
  }
  const auto units = measures::units_like(measure.unit);
  if (measure.unit.empty()) {
    table.refuse("unit", fmt::format("{} has no unit; omit unit", measure.name));
  }
  if (!table.has("unit")) {
    table.refuse_missing("unit",
                         fmt::format("the unit of {}: {}", measure.name, fmt::join(units, " or ")));
  }
  table.refuse("unit", fmt::format("unit is \"{}\"; for {} it must be {}", unit, measure.name,
                                   fmt::join(units, " or ")));
}

void read_text_limit(const Table& table, const measures::Measure& measure,
                     Expectation& expectation) {
  for (const char* key : {"min", "max"}) {
    if (table.has(key)) {
      table.refuse(key, fmt::format("{} is a text, not a number; give equals in place of {}",
                                    measure.name, key));
    }
  }
  expectation.equals = table.find_text("equals");
  if (!expectation.equals) {
    table.refuse_missing("equals", fmt::format("the value that {} must have", measure.name));
  }
  const auto& texts = measure.text_values;
  if (std::count(texts.begin(), texts.end(), *expectation.equals) == 0) {
    table.refuse("equals",
                 fmt::format("equals is \"{}\"{}", *expectation.equals,
                             keys::suggestion(*expectation.equals, texts, "valid values")));
  }
}

void read_number_limits(const Table& table, const measures::Measure& measure,
                        Expectation& expectation) {
  if (table.has("equals")) {
    table.refuse("equals", fmt::format("{} is a number; give min, max or both in place of equals",
                                       measure.name));
  }
  expectation.min = table.find_number("min");
  expectation.max = table.find_number("max");
  if (!expectation.min && !expectation.max) {
    table.refuse_missing("min", fmt::format("min, max or both, the limits of {}", measure.name));
  }
  if (expectation.min && expectation.max && *expectation.min > *expectation.max) {
    table.refuse("min", fmt::format("min is {}; it must be at most {} (max)", *expectation.min,
                                    *expectation.max));
  }
}

std::vector<std::string> read_groups(const Table& table, const std::vector<Outlet>& outlets) {
  const auto known = groups_of(outlets);
  std::vector<std::string> groups;
  for (const PlacedText& group : table.texts("outlets")) {
    if (std::find(known.begin(), known.end(), group.text) == known.end()) {
      table.refuse(group.at, fmt::format("unknown group \"{}\"{}", group.text,
                                         keys::suggestion(group.text, known, "groups")));
    }
    groups.push_back(group.text);
  }
  return groups;
}

}  // namespace

keys::Key expect_keys() {
  return keys::tables(
             "expect",
             "Limits of the measured values; at least one. Measures without a limit are reported "
             "for information.",
             {keys::text("measure", "quantity to check; `gsbench measures` lists all")
                  .permits("name of a measure")
                  .require("the name of a measure, as listed by `gsbench measures`"),
              keys::text("unit", "unit of `min` and `max`")
                  .permits("unit of the measure, or one that converts to it")
                  .or_else("required if the measure has a unit"),
              keys::number("min", "`unit`", {},
                           "lowest accepted value, inclusive; give `min`, `max` or both"),
              keys::number("max", "`unit`", {}, "highest accepted value, inclusive"),
              keys::text("equals", "required value, for measures that are texts")
                  .or_else("required if the measure is a text"),
              keys::array("outlets", keys::text("", ""), "groups that the limit applies to")
                  .permits("array of groups")
                  .or_else("all")})
      .require("at least one [[expect]], the limits of the run");
}

std::vector<Expectation> read_expectations(const Table& top, const std::vector<Outlet>& outlets) {
  std::vector<Expectation> expectations;
  for (const Table& table : top.tables("expect")) {
    Expectation expectation;
    expectation.measure = table.text("measure");
    const measures::Measure& measure = find_measure(table, expectation.measure);
    expectation.unit = read_unit(table, measure);
    if (measure.is_text()) {
      read_text_limit(table, measure, expectation);
    } else {
      read_number_limits(table, measure, expectation);
    }
    expectation.groups = read_groups(table, outlets);
    expectation.line = table.at("measure").line;
    expectations.push_back(std::move(expectation));
  }
  return expectations;
}

}  // namespace gsbench::profile
