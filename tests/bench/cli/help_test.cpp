#include "gsbench_process.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;

// Entries of a section of a help text ("Options:" and so on) and their descriptions. A line starts
// with two spaces and the name; the description follows after two spaces or on further indented
// lines.
std::map<std::string, std::string> entries(const std::string& help, const std::string& section) {
  std::map<std::string, std::string> found;
  std::istringstream lines(help.substr(std::min(help.find(section + ":\n"), help.size())));
  std::string line;
  std::string name;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty()) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start > 2) {
      found[name] += (found[name].empty() ? "" : " ") + line.substr(start);
      continue;
    }
    const std::size_t end = line.find("  ", start);
    name = line.substr(start, end - start);
    found[name] = end == std::string::npos ? "" : line.substr(line.find_first_not_of(' ', end));
  }
  return found;
}

// The first missing part of the help of a command; empty if it is complete.
std::string lacking(const std::string& command, const std::string& description,
                    const std::string& help) {
  if (description.empty() || help.rfind(description + "\n", 0) != 0) {
    return "a description";
  }
  if (help.find("\nUsage: gsbench " + command + " ") == std::string::npos) {
    return "its usage";
  }
  const auto options = entries(help, "Options");
  if (options.empty()) {
    return "options";
  }
  for (const auto& [option, text] : options) {
    if (text.empty()) {
      return "a description of " + option;
    }
  }
  const std::size_t example = std::min(help.find("\nExample"), help.size());
  const bool shown = help.find("\n  gsbench " + command, example) != std::string::npos;
  return shown ? "" : "an example";
}

TEST(Help, EveryCommandHasADescriptionOptionsAndAnExample) {
  const Outcome outcome = run_gsbench({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("INCONCLUSIVE"));
  const auto commands = entries(outcome.out, "Commands");
  EXPECT_THAT(commands, Contains(Key("run")));
  EXPECT_THAT(commands, Contains(Key("monitor")));
  for (const auto& [command, description] : commands) {
    const Outcome help = run_gsbench({command, "--help"});
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_EQ(lacking(command, description, help.out), "") << command << "\n" << help.out;
  }
}

TEST(Help, TheCheckFindsEachMissingPart) {
  const std::string whole =
      "Plays\nUsage: gsbench play [OPTIONS]\n\nOptions:\n  -h,--help    Print this\n"
      "  --port TEXT Excludes: --station\n               A port\n\nExample:\n  gsbench play\n";
  EXPECT_THAT(lacking("play", "Plays", whole), IsEmpty());
  EXPECT_EQ(lacking("play", "", whole), "a description");
  const std::vector<std::pair<std::string, std::string>> losses = {
      {"Plays", "a description"},
      {" play [", "its usage"},
      {"Options:", "options"},
      {"               A port\n", "a description of --port TEXT Excludes: --station"},
      {"Example:", "an example"},
      {"  gsbench play\n", "an example"}};
  for (const auto& [removed, missing] : losses) {
    std::string text = whole;
    EXPECT_EQ(lacking("play", "Plays", text.erase(text.find(removed), removed.size())), missing);
  }
}

TEST(Help, ListShowsNamesAndTitlesOfTheShippedFiles) {
  const Outcome outcome = run_gsbench({"list"});
  for (const std::string name :
       {"paper/loss-500mw", "events/gb-2019", "disturbances/dead-bus", "ieee24-by-unit",
        "island-60hz", "Illustrative 60 Hz island system of 6 GW"}) {
    EXPECT_THAT(outcome.out, HasSubstr(name));
  }
}

}  // namespace
}  // namespace gsbench::test
