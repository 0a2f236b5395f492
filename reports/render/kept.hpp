// What was kept of an outlet in a run that was interrupted, or ended by a fault of the bench:
// nothing was judged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <render/view.hpp>

namespace gsbench::render {

struct Kept {
  std::size_t measurements = 0;
  std::int64_t last_tick = 0;       // of the last measurement, if there is one
  std::vector<record::Mark> marks;  // events, decisions and relay changes, in the order of time
};
Kept kept_of(const View& view, std::size_t index);

// "126 measurements, up to 2.000 s of 8.000 s; event 1.100 s; decision 1.700 s; relay sensed open
// 1.706 s".
std::string kept_sentence(const record::RunRecord& run, const Kept& kept);

// All marks of an outlet, a line each: "1.700 s  Decision: 148 MW, reason".
std::string kept_list(const record::RunRecord& run, const record::OutletRecord& outlet);

}  // namespace gsbench::render
