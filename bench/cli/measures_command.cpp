#include "commands.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <measures/catalogue.hpp>

namespace gsbench::cli {
namespace {

std::string unit_or_words(const measures::Measure& measure) {
  if (!measure.is_text()) {
    return measure.unit.empty() ? "number" : measure.unit;
  }
  return fmt::format("{}", fmt::join(measure.text_values, "|"));
}

int measures(const bool& json) {
  if (json) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const measures::Measure& measure : measures::catalogue()) {
      out.push_back({{"name", measure.name},
                     {"unit", measure.unit},
                     {"words", measure.text_values},
                     {"definition", measure.definition},
                     {"needs", measure.needs}});
    }
    print_json(out);
    return kPassed;
  }
  for (const measures::Measure& measure : measures::catalogue()) {
    std::printf("%s [%s]\n    %s\n    Needs: %s.\n", measure.name.c_str(),
                unit_or_words(measure).c_str(), measure.definition.c_str(), measure.needs.c_str());
  }
  return kPassed;
}

}  // namespace

void add_measures(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "measures", "What a profile can set limits to: names, units, definitions", measures);
  command.add_flag("--json", arguments, "Print as JSON");
  command.footer("Example:\n  gsbench measures");
}

}  // namespace gsbench::cli
