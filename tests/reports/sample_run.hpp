// A run of the 500 MW case as a record would hold it, made by formula: true frequency by eq. (6)
// with the constants of the 24-bus system, outlets that lag and are noisy, estimates that settle
// from 310 MW. Nothing of it is measured; it is for the tests of what is made from records.
#pragma once

#include <record/run_record.hpp>

namespace gsbench::sample {

// Half of the outlets shed (accumulated power 100 MW), half stay on (200 MW).
record::RunRecord loss_500mw(int outlet_count = 8);

// Every outlet steady at 50 Hz, a report each 16 ms, with slow wander and noise.
record::RunRecord steady(int outlet_count, double duration_s);

// Writes it into a new store.
void write(const std::string& path, const record::RunRecord& run);

void add_report(record::MeasurementTrace& trace, std::int64_t tick, double frequency_hz,
                double rocof_hz_s, double voltage_pu, bool valid);

record::MeasurementResult& measurement(record::OutletRecord& outlet, const std::string& name);

}  // namespace gsbench::sample
