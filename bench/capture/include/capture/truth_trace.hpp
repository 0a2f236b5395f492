// The true frequency of a run as a record keeps it.
#pragma once

#include <cstdint>

#include <record/run_record.hpp>
#include <waveform/truth.hpp>

namespace gsbench::capture {

// One entry every 16 ms and two at each corner, just before it and at it, then thinned: straight
// lines between those that are left are right within 0.05 mHz and 5 mHz/s at those that are not.
record::TruthTrace truth_trace(const waveform::Truth& truth, std::int64_t duration_ticks,
                               std::int64_t sample_rate_hz);

}  // namespace gsbench::capture
