#include "sections.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

using keys::Table;
using keys::Word;

// Ids of the outlets that `words` name, by id or by group, each once and in the plan's order.
std::vector<std::string> named_outlets(const Table& table, const std::vector<Word>& words,
                                       const std::vector<Outlet>& outlets) {
  const auto names = [](const Word& word, const Outlet& outlet) {
    return word.text == outlet.id || word.text == outlet.group;
  };
  for (const Word& word : words) {
    if (std::none_of(outlets.begin(), outlets.end(),
                     [&](const Outlet& outlet) { return names(word, outlet); })) {
      auto known = groups_of(outlets);
      for (const Outlet& outlet : outlets) {
        known.push_back(outlet.id);
      }
      table.refuse(word.at, fmt::format("no outlet or group \"{}\"{}", word.text,
                                        keys::suggestion(word.text, known, "groups and outlets")));
    }
  }
  std::vector<std::string> ids;
  for (const Outlet& outlet : outlets) {
    if (std::any_of(words.begin(), words.end(),
                    [&](const Word& word) { return names(word, outlet); })) {
      ids.push_back(outlet.id);
    }
  }
  return ids;
}

}  // namespace

keys::Key command_keys() {
  return keys::tables("command", "What the control centre sends while the run is on.",
                      {time_in_run("when the control centre sends it"),
                       keys::array("outlets", keys::text("", ""), "to whom")
                           .permits("array of groups or ids")
                           .or_else("all"),
                       keys::word("switch", {"off", "on"}, "what").require("\"off\" or \"on\"")});
}

std::vector<Command> read_commands(const Table& top, const std::vector<Outlet>& outlets,
                                   double duration_s) {
  std::vector<Command> commands;
  for (const Table& table : top.tables("command")) {
    Command command;
    command.at_s = table.number("at_s", within_run(duration_s));
    command.outlets = named_outlets(table, table.words("outlets"), outlets);
    command.switch_on = table.text("switch") == "on";
    commands.push_back(std::move(command));
  }
  std::stable_sort(commands.begin(), commands.end(),
                   [](const Command& a, const Command& b) { return a.at_s < b.at_s; });
  return commands;
}

}  // namespace gsbench::profile
