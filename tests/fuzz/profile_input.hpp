// Property that must hold for any text given to the profile loader.
#pragma once

#include <functional>
#include <string>

#include <profile/load.hpp>

namespace gsbench::fuzz {

using ParseProfile = std::function<profile::Plan(const std::string& text)>;

// The profile loader of gsbench.
profile::Plan parse_as_gsbench(const std::string& text);

// Returns what `parse` does wrong with this text, or an empty string. It must return a valid plan
// that can be played, or throw ConfigurationError with file, line and column.
std::string wrong_with(const std::string& text, const ParseProfile& parse = parse_as_gsbench);

}  // namespace gsbench::fuzz
