// Station files: where the outlets are and how they are reached. Who tests edits these, and never
// what is tested. profiles/README.md documents every key.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <keys/key.hpp>
#include <profile/load.hpp>
#include <profile/plan.hpp>
#include <station/physical_outlets.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// One that was read: of one of the kinds in station_kinds.cpp.
class StationFile {
 public:
  virtual ~StationFile() = default;
  // How many outlets it has; none: as many as a plan asks for.
  virtual std::optional<std::size_t> outlets() const { return std::nullopt; }
  // Outlets that can be reached without a run; none: they are there only while one plays to them.
  virtual std::optional<PhysicalOutlets> reachable() const { return std::nullopt; }
  // Throws profile::ConfigurationError where nothing plays to its outlets, std::runtime_error where
  // it cannot be set up.
  virtual std::unique_ptr<Station> make_station(const profile::Plan& plan,
                                                const SimulatedOptions& simulated) const = 0;

  std::string name;
  std::string title;
  std::string path;
};

const keys::Key& station_keys();

// `name`: a shipped station ("emulated") or a path to a .toml file. Throws
// profile::ConfigurationError.
std::unique_ptr<StationFile> load_station(const std::string& name);

// In alphabetical order; one that cannot be read is listed with the reason for its title.
std::vector<profile::ProfileSummary> list_stations();

// A station with fewer outlets than the profile asks for plays to some of each group: the plan with
// just those. Throws profile::ConfigurationError where a group would be left without one.
profile::Plan fit_to_station(const StationFile& station, const profile::Plan& plan);

}  // namespace gsbench::station
