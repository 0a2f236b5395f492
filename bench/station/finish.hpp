// Ends a run's record, on the disk too where there is a writer.
#pragma once

#include <record/run_record.hpp>
#include <record/store.hpp>

namespace gsbench::station {

// Throws record::StoreError. `writer` may be nullptr.
void finish(record::RunRecord& run, record::Writer* writer);

}  // namespace gsbench::station
