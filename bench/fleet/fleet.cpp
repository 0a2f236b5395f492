#include <algorithm>
#include <string>

#include <fmt/format.h>

#include <campaign/work.hpp>
#include <fleet/fleet.hpp>
#include <models/noise.hpp>
#include <outlet/decision.hpp>

namespace gsbench::fleet {

Fleet make_fleet(const FleetOptions& options) {
  campaign::demand(options.groups > 0 && options.per_group > 0 &&
                       options.groups <= kMostOutlets / options.per_group,
                   fmt::format("a fleet of {} × {} outlets: it must have 1 … {}", options.groups,
                               options.per_group, kMostOutlets));
  campaign::demand(
      options.least_w >= 0.0 && options.most_w > 0.0 && options.most_w >= options.least_w &&
          options.most_w <= 1e9,
      fmt::format("an appliance has {:g} … {:g} W: its least power must be at least 0, its "
                  "most above 0 and at most 10⁹ W",
                  options.least_w, options.most_w));
  Fleet fleet;
  fleet.per_group = options.per_group;
  fleet.accumulation = options.accumulation;
  fleet.power_w.reserve(options.groups * options.per_group);
  const models::Stream stream = {options.seed, models::kAppliance, 0};
  for (std::size_t group = 0; group < options.groups; ++group) {
    double group_w = 0.0;
    for (std::size_t i = 0; i < options.per_group; ++i) {
      const double part = models::uniform(stream, fleet.power_w.size());
      const auto power_w =
          static_cast<float>(options.least_w + (options.most_w - options.least_w) * part);
      fleet.power_w.push_back(power_w);
      group_w += static_cast<double>(power_w);
    }
    const double group_mw = 1e-6 * group_w;
    fleet.group_mw.push_back(group_mw);
    fleet.accumulated_mw.push_back(
        control_centre::accumulated_mw(fleet.power_mw, group_mw, options.accumulation));
    fleet.power_mw += group_mw;
  }
  return fleet;
}

FleetOptions in_fewer_outlets(const FleetOptions& options, std::size_t outlets) {
  FleetOptions few = options;
  const double each_is = static_cast<double>(few.groups) * static_cast<double>(few.per_group) /
                         static_cast<double>(outlets);
  few.groups = outlets;
  few.per_group = 1;
  few.least_w *= each_is;
  few.most_w *= each_is;
  return few;
}

std::vector<double> switch_off_hz(const grid::Grid& grid, const Fleet& fleet,
                                  control_centre::Rules rules) {
  grid::Grid with_groups = grid;
  with_groups.blocks.clear();
  for (std::size_t group = 0; group < fleet.groups(); ++group) {
    with_groups.blocks.push_back({std::to_string(group + 1), fleet.group_mw[group]});
  }
  std::vector<double> all;
  for (const control_centre::BlockSetting& block :
       control_centre::block_settings(with_groups, fleet.accumulation, rules)) {
    all.push_back(block.switch_off_hz);
  }
  return all;
}

Shed count_shed(const Fleet& fleet, const std::vector<std::uint8_t>& off) {
  Shed shed;
  shed.off_in_group.assign(fleet.groups(), 0);
  for (std::size_t outlet = 0; outlet < fleet.outlets(); ++outlet) {
    if (off[outlet] != 0) {
      shed.power_mw += 1e-6 * static_cast<double>(fleet.power_w[outlet]);
      ++shed.outlets;
      ++shed.off_in_group[outlet / fleet.per_group];
    }
  }
  const auto& groups = shed.off_in_group;
  const auto partly = std::find_if(groups.begin(), groups.end(),
                                   [&](std::uint32_t count) { return count < fleet.per_group; });
  shed.first_partly = static_cast<std::size_t>(partly - groups.begin());
  const auto last =
      std::find_if(groups.rbegin(), groups.rend(), [](std::uint32_t count) { return count > 0; });
  shed.end_partly = static_cast<std::size_t>(groups.rend() - last);
  return shed;
}

bool sheds(const Fleet& fleet, std::size_t outlet, float loss_mw, float threshold_mw) {
  return gs::outlet::must_shed(gs::outlet::required_mw(loss_mw, threshold_mw),
                               static_cast<float>(fleet.accumulated_mw[outlet / fleet.per_group]));
}

Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, float threshold_mw) {
  std::vector<std::uint8_t> off(fleet.outlets());
  for (std::size_t outlet = 0; outlet < off.size(); ++outlet) {
    off[outlet] = sheds(fleet, outlet, loss_mw[outlet], threshold_mw) ? 1 : 0;
  }
  return count_shed(fleet, off);
}

}  // namespace gsbench::fleet
