// What was kept of an outlet in a run that was interrupted, or ended by a fault of the bench:
// nothing was judged.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

bool was_judged(const record::RunRecord& run);

// Its events, decisions and relay changes, in the order of time.
std::vector<record::Mark> kept_marks(const record::OutletRecord& outlet);

// "126 measurements, up to 2.000 s of 8.000 s; event 1.100 s; decision 1.700 s; relay sensed open
// 1.706 s". `outlet` has its reports, as below.
std::string kept_sentence(const record::RunRecord& run, const record::OutletRecord& outlet);

// All its marks, a line each: "1.700 s  Decision: 148 MW, reason".
std::string kept_list(const record::RunRecord& run, const record::OutletRecord& outlet);

}  // namespace gsbench::render
