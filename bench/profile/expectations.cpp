#include "sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <measures/catalogue.hpp>

namespace gsbench::profile {
namespace {

using keys::Table;
using keys::Word;

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
    table.refuse("unit", fmt::format("{} has no unit; leave it out", measure.name));
  }
  if (!table.has("unit")) {
    table.refuse_missing("unit",
                         fmt::format("{} is in {}", measure.name, fmt::join(units, " or ")));
  }
  table.refuse("unit", fmt::format("{} is not in \"{}\"; its unit must be {}", measure.name, unit,
                                   fmt::join(units, " or ")));
}

void read_word_limit(const Table& table, const measures::Measure& measure,
                     Expectation& expectation) {
  for (const char* key : {"min", "max"}) {
    if (table.has(key)) {
      table.refuse(key, fmt::format("{} is a word, not a number; it takes equals", measure.name));
    }
  }
  expectation.equals = table.find_text("equals");
  if (!expectation.equals) {
    table.refuse_missing("equals", fmt::format("the word that {} must be", measure.name));
  }
  const auto& words = measure.words;
  if (std::count(words.begin(), words.end(), *expectation.equals) == 0) {
    table.refuse("equals",
                 fmt::format("equals is \"{}\"{}", *expectation.equals,
                             keys::suggestion(*expectation.equals, words, "what it can be")));
  }
}

void read_number_limits(const Table& table, const measures::Measure& measure,
                        Expectation& expectation) {
  if (table.has("equals")) {
    table.refuse("equals", fmt::format("{} is a number; it takes min and max", measure.name));
  }
  expectation.min = table.find_number("min");
  expectation.max = table.find_number("max");
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
                                        keys::suggestion(word.text, known, "groups")));
    }
    groups.push_back(word.text);
  }
  return groups;
}

}  // namespace

keys::Key expect_keys() {
  return keys::tables(
             "expect",
             "At least one: limits, declared before the run. A measurement without a limit is "
             "reported for information.",
             {keys::text("measure", "what is judged; `gsbench measures` lists them")
                  .permits("a name of the catalogue")
                  .require(),
              keys::text("unit", "unit of `min` and `max`")
                  .permits("the measure's, or one that converts into it")
                  .or_else("required, where the measure has one"),
              keys::number("min", "`unit`", {}, "inclusive; `min`, `max` or both"),
              keys::number("max", "`unit`", {}, "inclusive"),
              keys::text("equals", "what a measure that is a word must be")
                  .permits("a word")
                  .or_else("required for words"),
              keys::array("outlets", keys::text("", ""), "whose")
                  .permits("array of groups")
                  .or_else("all")})
      .require("at least one [[expect]]: a run without limits proves nothing");
}

std::vector<Expectation> read_expectations(const Table& top, const std::vector<Outlet>& outlets) {
  std::vector<Expectation> expectations;
  for (const Table& table : top.tables("expect")) {
    Expectation expectation;
    expectation.measure = table.text("measure");
    const measures::Measure& measure = find_measure(table, expectation.measure);
    expectation.unit = read_unit(table, measure);
    if (measure.is_word()) {
      read_word_limit(table, measure, expectation);
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
