// The paper's §6 computed again: each of its tables and figures beside ours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <campaign/work.hpp>
#include <grid/grid.hpp>
#include <record/page.hpp>

namespace gsbench::reproduce {

struct Item {
  std::string id;     // "table4"
  std::string title;  // with the paper's section
};

// In the paper's order.
const std::vector<Item>& items();

struct Options {
  std::vector<std::string> only;  // ids; none: all
  std::uint64_t trajectories = 1000000;
  std::uint64_t seed = 1;
};

// What was reproduced. Throws std::invalid_argument for an id that there is none of, and as the
// campaigns do. Stopped, it holds what was done so far, and says so.
record::Page reproduce(const grid::Grid& grid, const Options& options,
                       const campaign::Execution& execution);

}  // namespace gsbench::reproduce
