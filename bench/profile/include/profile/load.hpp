// Profiles and grids from TOML files. Strict: an unknown key, a wrong type or unit, a value out of
// range, a missing grid: all are refused with `file:line:column: what, and what would be right`.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <profile/plan.hpp>

namespace gsbench::profile {

// Bad usage, profile, grid or settings: exit code 2. what() is the whole message.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Folders that profiles are looked for in: $GSBENCH_PROFILES if set, else the shipped ones.
std::string profiles_folder();

struct Overrides {                       // of the command line
  std::optional<std::uint64_t> seed;
  std::string trace_path;                // replays this recording in place of the profile's stimulus
  waveform::TraceColumns trace_columns;
};

// `name`: a shipped profile ("paper/loss-500mw") or a path to a .toml file.
Plan load_profile(const std::string& name, const Overrides& overrides = {});

// `name`: a shipped grid ("ieee24") or a path to a .toml file.
grid::Grid load_grid(const std::string& name);

struct ProfileSummary {
  std::string name;
  std::string title;
};
std::vector<ProfileSummary> list_profiles();
std::vector<std::string> list_grids();

}  // namespace gsbench::profile
