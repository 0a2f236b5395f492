// A run's verdict in words.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

// One sentence: why the verdict is what it is.
std::string verdict_sentence(const record::RunRecord& run);

// Why an outlet's verdict is worse than its measurements: what went wrong with it, where that is
// known.
std::string outlet_sentence(const record::OutletRecord& outlet);

// Outlets with which something went wrong.
std::vector<const record::OutletRecord*> faulty_outlets(const record::RunRecord& run);

// What was played, where the profile's text does not say it by itself; empty where it does.
std::string played_sentence(const record::RunRecord& run);

// Judged measurements that did not pass, worst verdict first.
struct Shortfall {
  const record::OutletRecord* outlet;
  const record::MeasurementResult* result;
};
std::vector<Shortfall> shortfalls(const record::RunRecord& run);

// "112.00 ± 0.13 ms, limit ≤ 100 ms: reason"
std::string shortfall_text(const record::MeasurementResult& result);

}  // namespace gsbench::render
