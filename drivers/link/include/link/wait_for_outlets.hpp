// Waits until outlets have joined a link.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

// Called about every 2 ms during the wait. `joined`: how many of the named outlets have joined. An
// error ends the wait with this error.
using Meanwhile = std::function<drivers::Status(std::size_t joined)>;

// Opens the link. `named` lists outlets by id, or by place (OutletPresence::where) if the id is not
// known. The call blocks until all of them have joined, then 200 ms more to find a second outlet
// with the same id. If one leaves meanwhile, it blocks for `patience`: the outlet may come back, or
// be one of two that take each other's place. It blocks for `patience` at most. With `others_for`
// > 0, it blocks for at least `others_for`.
//
// The result has one entry for each name, in the order of `named`. The entry of an outlet that did
// not join has a fault, the name as id, and an empty place. With `others_for` > 0, the entries of
// all other outlets follow.
//
// If two outlets report the same id in two places, both have a fault, and their ids include their
// places. Messages that arrive during the call are dropped. Returns an error if the link fails, and
// closes it.
[[nodiscard]] drivers::Result<std::vector<OutletPresence>> wait_for_outlets(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for = {});

// The same on a link that is open.
[[nodiscard]] drivers::Result<std::vector<OutletPresence>> wait_on_open_link(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for = {}, const Meanwhile& meanwhile = {});

}  // namespace gsbench::link
