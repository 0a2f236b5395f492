#include "commands.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <measures/catalogue.hpp>

namespace gsbench::cli {
namespace {

constexpr const char* kIntroduction =
    "Outlets send a frequency report every 16 ms. Tracker: the outlet's measurement of frequency "
    "and ROCOF. Declared delay: the measuring delay that the outlet reports about itself. Relay "
    "sense: the bench's own input that sees the relay contact. \"Without link: yes\" marks "
    "measures that can also be limited for devices without a link, which are tested by their "
    "contact alone.\n";

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
                     {"needs", measure.needs},
                     {"needs_link", measure.needs_link}});
    }
    print_json(out);
    return kPassed;
  }
  print_wrapped(kIntroduction);
  for (const measures::Measure& measure : measures::catalogue()) {
    constexpr std::size_t kIndent = 4;
    const std::string needs =
        measure.needs == "nothing" ? "" : fmt::format("\nNeeds: {}.", measure.needs);
    const char* by_contact = measure.needs_link ? "" : " Without link: yes.";
    print_wrapped(fmt::format("{} [{}]\n{}{}{}", measure.name, unit_or_words(measure),
                              measure.definition, needs, by_contact),
                  kIndent);
  }
  return kPassed;
}

}  // namespace

void add_measures(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "measures", "List the measures that a profile can limit: units and definitions", measures);
  add_json_flag(command, arguments);
  command.footer("Example:\n  gsbench measures");
}

}  // namespace gsbench::cli
