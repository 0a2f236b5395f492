// What was kept of an outlet in a run that was interrupted, before anything was judged.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

// Its events, decisions and relay changes, in the order of time.
std::vector<record::Mark> kept_marks(const record::OutletRecord& outlet);

// "126 measurements, up to 2.000 s; event 1.100 s; decision 1.700 s; relay sensed open 1.706 s".
// `outlet` has its reports.
std::string kept_sentence(const record::RunRecord& run, const record::OutletRecord& outlet);

}  // namespace gsbench::render
