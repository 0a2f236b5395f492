#include "run_steps.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <measures/catalogue.hpp>
#include <profile/load.hpp>

namespace gsbench::station {
namespace {

bool is_addressed(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

void check_contact_only(const profile::Plan& plan, const profile::Outlet& outlet,
                        const Slot& slot) {
  const std::string who = fmt::format(
      "outlet {} is tested by its contact alone (slot {} has no link)", outlet.id, slot.place);
  bool any_limit = false;
  for (const profile::Expectation& limit : plan.expectations) {
    if (!is_addressed(limit.groups, outlet.group)) {
      continue;
    }
    const measures::Measure* measure = measures::find(limit.measure);
    if (measure != nullptr && measure->needs_link) {
      throw profile::ConfigurationError(fmt::format(
          "{}:{}: {} needs a link, but {}; possible measures are: {}", plan.path, limit.line,
          limit.measure, who, fmt::join(measures::measured_by_contact(), ", ")));
    }
    any_limit = true;
  }
  if (!any_limit) {
    throw profile::ConfigurationError(fmt::format(
        "{}: no limit applies to outlet {}, so it could not pass", plan.path, outlet.id));
  }
  for (const profile::SettingsUpdate& update : plan.settings) {
    if (update.outlets.count(outlet.id) > 0) {
      throw profile::ConfigurationError(
          fmt::format("{}: the settings of {} s cannot be sent: {}", plan.path, update.at_s, who));
    }
  }
  for (const profile::Command& command : plan.commands) {
    if (is_addressed(command.outlets, outlet.id)) {
      throw profile::ConfigurationError(
          fmt::format("{}: the command at {} s cannot be sent: {}", plan.path, command.at_s, who));
    }
  }
}

}  // namespace

void check_offered(const profile::Plan& plan, const std::vector<Slot>& slots) {
  for (std::size_t i = 0; i < slots.size() && i < plan.outlets.size(); ++i) {
    if (slots[i].link_id) {
      continue;
    }
    if (!slots[i].relay_channel) {
      throw profile::ConfigurationError(
          fmt::format("{}: the slot {} of outlet {} has neither a link nor a relay channel",
                      plan.path, slots[i].place, plan.outlets[i].id));
    }
    check_contact_only(plan, plan.outlets[i], slots[i]);
  }
}

}  // namespace gsbench::station
