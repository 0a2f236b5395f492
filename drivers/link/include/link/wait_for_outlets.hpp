// Opens a link and waits for outlets.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

// `named`: ids, or places (OutletPresence::where) where an id is not known. Blocks until all of
// them have joined, and some time more for a second one of the same id, but not longer than
// `patience`. Returns one for each name, in that order, with a fault where it did not join; such a
// one has its name for an id, and no place. Where `others_for` is not 0, waits so long in any case
// and returns after them all that joined or are at fault without being named.
//
// Outlets that say the same id in two places are both at fault, and have their places in their ids:
// which of them was meant nobody can tell. What outlets send meanwhile is passed over.
[[nodiscard]] drivers::Result<std::vector<OutletPresence>> wait_for_outlets(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for = {});

}  // namespace gsbench::link
