// Where profiles, grids and stations are on disk: the shipped ones, and the user's own in
// $XDG_DATA_HOME/gsbench/profiles. If $GSBENCH_PROFILES is set, that folder takes the place of both.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::profile {

struct NamedFile {
  std::string name;  // "paper/loss-500mw", "ieee24"
  std::string path;
};

// Throw ConfigurationError where there is no such file.
std::string find_profile(const std::string& name_or_path);  // its path
NamedFile find_station(const std::string& name_or_path);

// `folder`: what a relative path is relative to.
std::optional<NamedFile> find_grid(const std::string& name_or_path, const std::string& folder);
std::string no_such_grid(const std::string& name_or_path);

// "paper/loss-500mw" for a shipped or own profile, else the file's name without extension.
std::string profile_name(const std::string& path);

// `path` as it stands, where it is absolute; else below the folder that `beside` is in.
std::string resolve(const std::string& path, const std::string& beside);

bool is_regular_file(const std::string& path);

// Throws ConfigurationError where it is no readable regular file.
std::string read_file(const std::string& path);

// Hexadecimal. Of a file: throws ConfigurationError where it cannot be read.
std::string sha256(const std::string& text);
std::string sha256_of_file(const std::string& path);

// By name. Throw ConfigurationError if there is no folder of profiles, or two files have one name.
std::vector<NamedFile> all_profiles();
std::vector<NamedFile> all_grids();
std::vector<NamedFile> all_stations();

}  // namespace gsbench::profile
