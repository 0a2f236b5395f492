// The kinds of stations that a station file can describe. A new one is its own files and a line in
// station_file.cpp.
#pragma once

#include <string>
#include <vector>

#include <keys/table.hpp>
#include <station/station_file.hpp>

namespace gsbench::station {

struct StationKind {
  std::string name;             // as `kind` in a station file
  std::string meaning;          // what its outlets are, for documents
  std::vector<keys::Key> keys;  // that only this kind has
  // Fills in what follows `file`'s name, title and path; relative paths in it are beside it.
  void (*read)(const keys::Table& top, StationFile& file);
};

// One file each.
StationKind simulated_kind();
StationKind emulated_kind();
StationKind physical_kind();

constexpr std::size_t kLongestId = 32;  // that an outlet can say

}  // namespace gsbench::station
