#include <station/station_file.hpp>

namespace gsbench::station {

profile::Plan fit_to_station(const StationFile& station, const profile::Plan& plan) {
  const std::size_t there = station.outlets().value_or(plan.outlets.size());
  if (there >= plan.outlets.size()) {
    return plan;
  }
  const std::vector<std::string> groups = profile::groups_of(plan.outlets);
  if (groups.size() > there) {
    throw profile::ConfigurationError(plan.path + ": has " + std::to_string(groups.size()) +
                                      " groups of outlets, and the station " + station.name +
                                      " only " + std::to_string(there) + " outlets");
  }
  // One of each group in turn.
  std::vector<bool> taken(plan.outlets.size(), false);
  for (std::size_t chosen = 0; chosen < there;) {
    for (const std::string& group : groups) {
      for (std::size_t i = 0; i < plan.outlets.size() && chosen < there; ++i) {
        if (!taken[i] && plan.outlets[i].group == group) {
          taken[i] = true;
          ++chosen;
          break;
        }
      }
    }
  }
  profile::Plan fitted = plan;
  fitted.outlets.clear();
  for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
    if (taken[i]) {
      fitted.outlets.push_back(plan.outlets[i]);
    }
  }
  return fitted;
}

}  // namespace gsbench::station
