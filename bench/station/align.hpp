// Brings what outlets said onto the run's time base, into their records.
#pragma once

#include <capture/capture.hpp>
#include <record/run_record.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// `markers`: the dips that were played around the run, by which the counts of outlets that count
// their own samples are aligned.
void align(const Station& station, const capture::Markers& markers, capture::Capture& capture,
           record::RunRecord& run);

}  // namespace gsbench::station
