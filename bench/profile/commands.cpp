#include "sections.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::profile {

using keys::PlacedText;
using keys::Table;

std::vector<std::string> named_outlets(const Table& table, const std::vector<Outlet>& outlets) {
  const std::vector<PlacedText> names = table.texts("outlets");
  const auto selects = [](const PlacedText& name, const Outlet& outlet) {
    return name.text == outlet.id || name.text == outlet.group;
  };
  for (const PlacedText& name : names) {
    if (std::none_of(outlets.begin(), outlets.end(),
                     [&](const Outlet& outlet) { return selects(name, outlet); })) {
      auto known = groups_of(outlets);
      for (const Outlet& outlet : outlets) {
        known.push_back(outlet.id);
      }
      table.refuse(name.at, fmt::format("unknown outlet or group \"{}\"{}", name.text,
                                        keys::suggestion(name.text, known, "groups and outlets")));
    }
  }
  std::vector<std::string> ids;
  for (const Outlet& outlet : outlets) {
    if (std::any_of(names.begin(), names.end(),
                    [&](const PlacedText& name) { return selects(name, outlet); })) {
      ids.push_back(outlet.id);
    }
  }
  return ids;
}

keys::Key command_keys() {
  return keys::tables("command", "Commands that the control centre sends during the run.",
                      {time_in_run("time at which the control centre sends the command"),
                       keys::array("outlets", keys::text("", ""), "recipients of the command")
                           .permits("array of groups or ids")
                           .or_else("all"),
                       keys::choice("switch", {"off", "on"}, "commanded state of the relay")
                           .require("\"off\" or \"on\"")});
}

std::vector<Command> read_commands(const Table& top, const std::vector<Outlet>& outlets,
                                   const RunTime& run) {
  std::vector<Command> commands;
  for (const Table& table : top.tables("command")) {
    Command command;
    command.at_s = table.number("at_s", run.starts());
    command.outlets = named_outlets(table, outlets);
    command.switch_on = table.text("switch") == "on";
    commands.push_back(std::move(command));
  }
  std::stable_sort(commands.begin(), commands.end(),
                   [](const Command& a, const Command& b) { return a.at_s < b.at_s; });
  return commands;
}

}  // namespace gsbench::profile
