// Record of a synthetic run of the 500 MW case, for tests of stores and reports. The frequency
// follows eq. (6) with the constants of the 24-bus system; measurements have delay and noise, and
// estimates settle from 310 MW.
#pragma once

#include <record/run_record.hpp>

namespace gsbench::sample {

// Half of the outlets shed (accumulated power 100 MW), half do not (200 MW).
record::RunRecord loss_500mw(int outlet_count = 8);

// All outlets at 50 Hz, with a report every 16 ms, slow drift and noise.
record::RunRecord steady(int outlet_count, double duration_s);

// Writes it into a new store.
void write(const std::string& path, const record::RunRecord& run);

void add_report(record::MeasurementTrace& trace, std::int64_t tick, double frequency_hz,
                double rocof_hz_s, double voltage_pu, bool valid);

record::MeasurementResult& measurement(record::OutletRecord& outlet, const std::string& name);

}  // namespace gsbench::sample
