// Stations and links from station files.
#pragma once

#include <memory>

#include <link/link.hpp>
#include <profile/station_spec.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Throws profile::ConfigurationError where the file asks for what cannot be: a physical station
// without a source, fewer outlets than the profile has groups.
std::unique_ptr<Station> make_station(const profile::StationSpec& spec, const profile::Plan& plan,
                                      const SimulatedOptions& simulated);

// To the outlets of a physical station. `looking`: ports that cannot be opened are left out, not an
// error.
std::unique_ptr<link::Link> make_link(const profile::StationSpec& spec, bool looking);

// A station with fewer outlets than the profile asks for plays to some of each group: the plan with
// just those. Throws profile::ConfigurationError where a group would be left without one.
profile::Plan fit_to_station(const profile::StationSpec& spec, const profile::Plan& plan);

}  // namespace gsbench::station
