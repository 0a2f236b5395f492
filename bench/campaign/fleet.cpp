#include <algorithm>
#include <stdexcept>

#include <campaign/fleet.hpp>
#include <models/noise.hpp>

namespace gsbench::campaign {

Fleet make_fleet(const FleetOptions& options) {
  if (options.groups == 0 || options.per_group == 0 ||
      options.groups > kMostOutlets / options.per_group) {
    throw std::invalid_argument("a fleet has 1 … 100 000 000 outlets");
  }
  if (!(options.least_w >= 0.0 && options.most_w > 0.0 && options.most_w >= options.least_w &&
        options.most_w <= 1e9)) {
    throw std::invalid_argument(
        "appliances take 0 … 1 000 000 000 W, the least no more than the most");
  }
  Fleet fleet;
  fleet.per_group = options.per_group;
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
    const double own = options.accumulation == Accumulation::kWholeGroup ? 1.0 : 0.5;
    fleet.group_mw.push_back(group_mw);
    fleet.accumulated_mw.push_back(fleet.power_mw + own * group_mw);
    fleet.power_mw += group_mw;
  }
  return fleet;
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

Shed shed_by_estimates(const Fleet& fleet, const std::vector<float>& loss_mw, double threshold_mw) {
  std::vector<std::uint8_t> off(fleet.outlets());
  for (std::size_t outlet = 0; outlet < off.size(); ++outlet) {
    const double required_mw = static_cast<double>(loss_mw[outlet]) - threshold_mw;
    const bool sheds =
        required_mw > 0.0 && required_mw > fleet.accumulated_mw[outlet / fleet.per_group];
    off[outlet] = sheds ? 1 : 0;
  }
  return count_shed(fleet, off);
}

}  // namespace gsbench::campaign
