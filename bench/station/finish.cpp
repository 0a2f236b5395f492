#include "finish.hpp"

#include "identity.hpp"

namespace gsbench::station {

void finish(record::RunRecord& run, record::Writer* writer) {
  run.finished_utc = utc_now();
  if (writer == nullptr) {
    return;
  }
  for (const record::OutletRecord& outlet : run.outlets) {
    writer->add_outlet(outlet);
  }
  writer->finish(run);
}

}  // namespace gsbench::station
