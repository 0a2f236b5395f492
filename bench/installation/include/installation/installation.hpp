// Where gsbench finds its own files and keeps its user's, and which version it is. No absolute path
// is compiled in, so an installation may be moved. Nothing here throws or blocks.
#pragma once

#include <filesystem>
#include <string>

namespace gsbench::installation {

// "0.1.0 (0123456789ab)": the release and the git revision it was built from, with "-dirty" if a
// source differed from that revision. Only "0.1.0" if it was not built in a git repository.
std::string version();

// A program installed beside this one, such as "gs-outlet".
std::filesystem::path program(const std::string& name);

// A folder of files that come with gsbench: "profiles", "instruments", "firmware". It is in
// share/gsbench, beside the folder of this program (../share/gsbench).
std::filesystem::path shipped(const std::string& name);

// A folder of the user's own files: "profiles", "runs". It is in $XDG_DATA_HOME/gsbench, by default
// ~/.local/share/gsbench (XDG Base Directory Specification 0.8). Empty if neither XDG_DATA_HOME nor
// HOME is set to an absolute path. The folder need not exist.
std::filesystem::path user_data(const std::string& name);

}  // namespace gsbench::installation
