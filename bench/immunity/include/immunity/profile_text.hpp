// A case as a profile, with which `gsbench run` plays it again: with other noise, and from the
// start of an outlet.
#pragma once

#include <string>

#include <immunity/settled_outlets.hpp>

namespace gsbench::immunity {

// The keys of [signal]. An oscillation's amplitude is rounded to 0.1 mHz, as drawn ones are.
std::string signal_keys(const Disturbance& disturbance, double noise_pct);

// The whole profile: no outlet may open its relay. `grid`: its name, or a path, which is absolute
// so that the profile can be kept in any folder.
std::string profile_text(const Disturbance& disturbance, std::uint32_t number,
                         const std::string& grid, const Options& options);

}  // namespace gsbench::immunity
