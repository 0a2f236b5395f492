// Completion for shells, from the definitions of the commands and their options.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace gsbench::cli {

// `words`: the command line after "gsbench"; the last word is to be completed and may be empty.
// Returns what that word may become: commands, options, one of a fixed set of values, or names of
// profiles, grids, stations, runs or sections. Which names are offered depends on the placeholder
// in the help: PROFILE, GRID, STATION, RUN or SECTION,…. Empty if nothing fits, so that the shell
// offers files.
std::vector<std::string> completions(const CLI::App& app, std::vector<std::string> words);

}  // namespace gsbench::cli
