#include "expectations.hpp"

#include "nearest.hpp"
#include "outlets.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <profile/units.hpp>

namespace gsbench::profile {
namespace {

const MeasureName& find_measure(const Table& table, const std::string& name,
                                const MeasureCatalogue& catalogue) {
  const auto found = std::find_if(catalogue.begin(), catalogue.end(),
                                  [&](const MeasureName& known) { return known.name == name; });
  if (found != catalogue.end()) return *found;
  std::vector<std::string> names;
  for (const MeasureName& known : catalogue) names.push_back(known.name);
  table.refuse("measure",
               fmt::format("unknown measure \"{}\"{}", name, suggestion(name, names, "measures")));
}

std::string read_unit(const Table& table, const MeasureName& measure) {
  std::string unit = table.text("unit").value_or("");
  if (unit_scale(unit, measure.unit)) return unit;
  const auto units = units_like(measure.unit);
  if (measure.unit.empty()) {
    table.refuse("unit", fmt::format("{} has no unit; leave it out", measure.name));
  }
  if (!table.has("unit")) {
    table.refuse_missing("unit",
                         fmt::format("{} is in {}", measure.name, fmt::join(units, " or ")));
  }
  table.refuse("unit", fmt::format("{} is not in \"{}\"; its unit must be {}", measure.name, unit,
                                   fmt::join(units, " or ")));
}

void read_word_limit(const Table& table, const MeasureName& measure, Expectation& expectation) {
  for (const char* key : {"min", "max"}) {
    if (table.has(key)) {
      table.refuse(key, fmt::format("{} is a word, not a number; it takes equals", measure.name));
    }
  }
  expectation.equals =
      measure.words.empty() ? table.text("equals") : table.choice("equals", measure.words);
  if (!expectation.equals) {
    table.refuse_missing("equals", fmt::format("the word that {} must be", measure.name));
  }
}

void read_number_limits(const Table& table, const MeasureName& measure, Expectation& expectation) {
  if (table.has("equals")) {
    table.refuse("equals", fmt::format("{} is a number; it takes min and max", measure.name));
  }
  expectation.min = table.number("min");
  expectation.max = table.number("max");
  if (!expectation.min && !expectation.max) {
    table.refuse_missing("min", fmt::format("min, max or both, of {}", measure.name));
  }
  if (expectation.min && expectation.max && *expectation.min > *expectation.max) {
    table.refuse("min", fmt::format("min is {}, above max {}: nothing could pass", *expectation.min,
                                    *expectation.max));
  }
}

std::vector<std::string> read_groups(const Table& table, const std::vector<Outlet>& outlets) {
  const auto known = groups_of(outlets);
  std::vector<std::string> groups;
  for (const Word& word : table.words("outlets")) {
    if (std::find(known.begin(), known.end(), word.text) == known.end()) {
      table.refuse(word.at, fmt::format("no group \"{}\"{}", word.text,
                                        suggestion(word.text, known, "groups")));
    }
    groups.push_back(word.text);
  }
  return groups;
}

}  // namespace

std::vector<Expectation> read_expectations(const Table& top, const std::vector<Outlet>& outlets,
                                           const MeasureCatalogue& catalogue) {
  std::vector<Expectation> expectations;
  for (const Value* value : top.tables("expect")) {
    const Table table(top.document(), *value, "[[expect]]",
                      {"measure", "unit", "min", "max", "equals", "outlets"});
    Expectation expectation;
    expectation.measure = table.required_text("measure");
    const MeasureName& measure = find_measure(table, expectation.measure, catalogue);
    expectation.unit = read_unit(table, measure);
    if (measure.word) {
      read_word_limit(table, measure, expectation);
    } else {
      read_number_limits(table, measure, expectation);
    }
    expectation.groups = read_groups(table, outlets);
    expectation.line = table.at("measure").line;
    expectations.push_back(std::move(expectation));
  }
  if (expectations.empty()) {
    top.refuse_missing("expect", "at least one [[expect]]: a run without limits proves nothing");
  }
  return expectations;
}

}  // namespace gsbench::profile
