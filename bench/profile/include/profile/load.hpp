// Profiles and grids from TOML files. Strict: an unknown key, a wrong type or unit, a value out of
// range, a missing grid: all are refused with `file:line:column: what, and what would be right`.
// profiles/README.md documents every key.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <keys/document.hpp>
#include <keys/key.hpp>
#include <profile/files.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

using keys::ConfigurationError;

// $GSBENCH_PROFILES if set, else the folder of the shipped profiles.
std::string profiles_folder();

// Seeds are 0 … this: whole numbers that every reader of JSON keeps exactly.
constexpr std::uint64_t kLargestSeed = std::uint64_t{1} << 53U;

// What the command line says in place of the profile.
struct Overrides {
  std::optional<std::uint64_t> seed;
  // Replays this recording, whole, in place of the profile's frequency, amplitude steps and phase
  // jumps; noise, harmonics and DC offset stay. Empty: none.
  std::string trace_path;
  recording::TraceColumns trace_columns;
};

// `name`: a shipped profile ("paper/loss-500mw") or a path to a .toml file.
Plan load_profile(const std::string& name, const Overrides& overrides = {});

// The same of a text, such as a run record keeps; grids and recordings it names by a relative path
// are looked for beside `path`.
Plan parse_profile(const std::string& text, const std::string& path,
                   const Overrides& overrides = {});

// `name`: a shipped grid ("ieee24") or a path to a .toml file.
grid::Grid load_grid(const std::string& name);

struct ProfileSummary {
  std::string name;
  std::string title;
};

// In alphabetical order. A profile that cannot be read is listed with the reason for its title.
std::vector<ProfileSummary> list_profiles();
std::vector<ProfileSummary> summaries_of(
    const std::vector<NamedFile>& files,
    const std::function<std::string(const NamedFile&)>& read_title);
std::vector<std::string> list_grids();

// What the files may say: every key, with unit, range and default.
const keys::Key& profile_keys();
const keys::Key& grid_keys();

}  // namespace gsbench::profile
