// Finds and reads the files of profiles, grids and stations: the shipped ones, and the user's own
// in $XDG_DATA_HOME/gsbench/profiles. If $GSBENCH_PROFILES is set, that folder replaces both.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gsbench::profile {

struct NamedFile {
  std::string name;  // "paper/loss-500mw", "ieee24"
  std::string path;
};

// Throw ConfigurationError if the file does not exist, or if both a shipped file and one of the
// user's own files have this name.
std::string find_profile(const std::string& name_or_path);  // returns the path
struct FoundProfiles {
  std::vector<std::string> names;  // what load_profile() takes
  bool of_folder = false;
};
// The profile itself, or every .toml file below a folder, sorted. A folder is a name among those of
// profiles ("cascades", "cascades/"), or a path; grids/ and stations/ in it are left out. Throws
// ConfigurationError if the name is unknown, or if nothing is in the folder.
FoundProfiles find_profile_or_folder(const std::string& name_or_path);
NamedFile find_station(const std::string& name_or_path);

// The same for a grid. `folder` is the base of a relative path. nullopt if the file does not exist.
std::optional<NamedFile> find_grid(const std::string& name_or_path, const std::string& folder);
// The name that find_grid() would give, and the path or name for messages. The file need not exist.
NamedFile copied_grid(const std::string& name_or_path, const std::string& folder);
std::string unknown_grid(const std::string& name_or_path);  // the message for that case

// "paper/loss-500mw" for a shipped or own profile, otherwise the file name without extension.
std::string profile_name(const std::string& path);

// Returns an absolute `path` unchanged. A relative `path` is relative to the folder of the file
// `beside`.
std::string resolve(const std::string& path, const std::string& beside);

bool is_regular_file(const std::string& path);

// Throws ConfigurationError if `path` is not a readable regular file of at most 4 MiB.
std::string read_file(const std::string& path);

// Checksum, hexadecimal.
std::string sha256(const std::string& text);

// Sorted by name. Throw ConfigurationError if the folder of profiles does not exist. Subfolders
// that may not be read are left out.
std::vector<NamedFile> all_profiles();
std::vector<NamedFile> all_grids();
std::vector<NamedFile> all_stations();
std::vector<std::string> names_of(const std::vector<NamedFile>& files);

}  // namespace gsbench::profile
