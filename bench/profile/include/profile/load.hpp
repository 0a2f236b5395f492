// Reads profiles and grids from TOML files. Strict: an unknown key, a wrong type or unit, a value
// out of range or a missing grid throws ConfigurationError with the message
// `file:line:column: what is wrong, and what would be right`. profiles/README.md documents all
// keys.
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

// The first folder that is searched. If $GSBENCH_PROFILES is set, it is that folder, and no other
// is searched. Otherwise it is the folder of the shipped profiles, and the user's own folder is
// searched next (profile/files.hpp).
std::string profiles_folder();

// Seeds are 0 … 2⁵³, which every JSON reader represents exactly.
constexpr std::uint64_t kLargestSeed = std::uint64_t{1} << 53U;

// Values of the command line that replace those of the profile.
struct Overrides {
  std::optional<std::uint64_t> seed;
  // A recording to play; empty: none. It replaces the profile's frequency source (losses, points or
  // recording), its oscillations, tones, flicker, amplitude and phase steps. Noise, harmonics and
  // DC offset stay. The length of the run is that of the recording's played part.
  std::string trace_path;
  recording::TraceFormat trace_format;
};

// Contents of files, as a run record has them. They are used in place of the files that the profile
// and the overrides name, which are then not opened and need not exist.
struct Copies {
  std::optional<std::string> grid;       // Plan::grid_text
  std::optional<std::string> recording;  // Recording::played_text; then Recording::sha256 is empty
};

// A format as text, for records: the keys of [signal.trace] but `file`. trace_format() reads it,
// and also one without a key that has been added since. Throws ConfigurationError.
std::string trace_options(const recording::TraceFormat& format);
recording::TraceFormat trace_format(const std::string& options);

// `name`: a profile in one of the folders searched ("paper/loss-500mw"), or the path of a .toml
// file.
Plan load_profile(const std::string& name, const Overrides& overrides = {});

// The same for the text of a profile, e.g. from a run record. Relative paths of grids and
// recordings are relative to the folder of `path`.
Plan parse_profile(const std::string& text, const std::string& path,
                   const Overrides& overrides = {}, const Copies& copies = {});

// `name`: a grid in one of the folders searched ("ieee24"), or the path of a .toml file.
grid::Grid load_grid(const std::string& name);

struct ProfileSummary {
  std::string name;
  std::string title;
};

// In alphabetical order. If a profile cannot be read, its title is the reason why.
std::vector<ProfileSummary> list_profiles();
std::vector<ProfileSummary> list_grids();
std::vector<ProfileSummary> summaries_of(
    const std::vector<NamedFile>& files,
    const std::function<std::string(const NamedFile&)>& read_title);

// Declarations of all keys, with unit, range and default.
const keys::Key& profile_keys();
const keys::Key& grid_keys();

}  // namespace gsbench::profile
