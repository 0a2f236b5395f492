// Opens a link and waits for outlets.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

// `named`: ids, or places (OutletPresence::where) if the id is not known. Blocks until all of them
// have joined and 200 ms more, to find a second outlet with the same id; at most `patience`. With
// `others_for` > 0 it blocks for at least that time.
//
// Returns one entry for each name, in the same order. An outlet that did not join has a fault, its
// name as id, and no place. With `others_for` > 0, all other outlets found follow.
//
// If two outlets report the same id in two places, both are faulty and their ids include their
// places. Messages that outlets send meanwhile are dropped. An error if the link fails.
[[nodiscard]] drivers::Result<std::vector<OutletPresence>> wait_for_outlets(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for = {});

}  // namespace gsbench::link
