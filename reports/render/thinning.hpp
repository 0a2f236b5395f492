// Which entries of a long series a plot needs: the extremes of each stretch of it, so that a
// thinned curve looks like the whole one and hides no spike.
#pragma once

#include <cstdint>
#include <vector>

namespace gsbench::render {

struct Stretch {
  std::int64_t from_tick;
  std::int64_t to_tick;
};

// Indices of the entries to keep, ascending, at most `most` (which is at least 20). All of them
// where they are not more. Otherwise: the first and the last; every entry within `whole` stretches,
// in their order while half of `most` lasts; and in equal parts of the rest least and greatest of
// both columns and the first NaN (a gap stays a gap).
std::vector<std::size_t> thinned(const std::vector<std::int64_t>& tick,
                                 const std::vector<double>& first,
                                 const std::vector<double>& second,
                                 const std::vector<Stretch>& whole, std::size_t most);

}  // namespace gsbench::render
