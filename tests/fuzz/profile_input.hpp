// What must hold for any text that is given to the profile loader.
#pragma once

#include <functional>
#include <string>

#include <profile/load.hpp>

namespace gsbench::fuzz {

using ParseProfile = std::function<profile::Plan(const std::string& text)>;

// The loader of gsbench, with the catalogue of the tests.
profile::Plan parse_as_gsbench(const std::string& text);

// What `parse` does wrong with this text; empty where it does right: it gives a plan that makes
// sense and can be played, or it refuses with file, line and column.
std::string wrong_with(const std::string& text, const ParseProfile& parse = parse_as_gsbench);

}  // namespace gsbench::fuzz
