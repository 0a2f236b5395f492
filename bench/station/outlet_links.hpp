// The links to the outlets of a physical station: [serial] and [mqtt] of its file.
#pragma once

#include <string>
#include <vector>

#include <keys/table.hpp>
#include <station/station_file.hpp>

namespace gsbench::station {

// [serial] and [mqtt].
std::vector<keys::Key> link_keys();

// What these two sections say; nothing of either if it is missing. Paths are relative to
// `file_path`. Throws keys::ConfigurationError.
PhysicalOutlets read_links(const keys::Table& top, const std::string& file_path);

}  // namespace gsbench::station
