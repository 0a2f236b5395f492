// One run of a plan on a station: claims the outlets, sends settings, plays, captures, judges. The
// station is in its safe state afterwards, however the run ended.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <record/store.hpp>
#include <station/station.hpp>

namespace gsbench::station {

struct RunOptions {
  record::Writer* writer = nullptr;           // keeps the run as it goes; none: nothing is kept
  const std::atomic<bool>* stop = nullptr;    // set from outside to end the run early
  std::function<void(double part)> progress;  // 0 … 1, of the playing
};

// A fault of the bench, a silent outlet or a stop does not throw: the record says ERROR and why.
// Throws profile::ConfigurationError for settings that the firmware refuses (before anything is
// played or written) and record::StoreError where the record cannot be written.
record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options);

}  // namespace gsbench::station
