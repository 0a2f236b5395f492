// The kinds of stations that a station file can describe. A new kind has its own files and one line
// in station_file.cpp.
#pragma once

#include <string>
#include <vector>

#include <keys/table.hpp>
#include <station/station_file.hpp>

namespace gsbench::station {

struct StationKind {
  std::string name;             // value of `kind` in a station file
  std::string meaning;          // description of its outlets, for the documentation
  std::vector<keys::Key> keys;  // keys of this kind only
  // Fills in all members of `file` except name, title and path. Relative paths are relative to
  // file.path.
  void (*read)(const keys::Table& top, StationFile& file);
};

// Each is defined in its own source file.
StationKind simulated_kind();
StationKind emulated_kind();
StationKind physical_kind();

constexpr std::size_t kLongestId = 32;  // limit of the protocol, characters

}  // namespace gsbench::station
