// What the control centre sends each outlet of a plan: derived from the grid (§4), as real outlets
// get it. The firmware never sees the grid itself.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <profile/plan.hpp>
#include <wire/messages.hpp>

namespace gsbench::station {

// Throws profile::ConfigurationError where the firmware would refuse them.
gs::outlet::Settings outlet_settings(const profile::Plan& plan, const profile::Outlet& outlet,
                                     std::uint32_t version);

// By name with the unit in it, for the record.
std::map<std::string, double> described(const gs::outlet::Settings& settings);

}  // namespace gsbench::station
