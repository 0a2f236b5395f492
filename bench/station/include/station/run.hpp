// Runs a plan on a station: claims the outlets, sends their settings, plays the signal, captures
// the reports and judges them. The station is in its safe state afterwards, however the run ends.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <record/store.hpp>
#include <station/station.hpp>

namespace gsbench::station {

struct RunOptions {
  record::Writer* writer = nullptr;           // stores the run while it proceeds; none: in memory
  const std::atomic<bool>* stop = nullptr;    // set from outside to end the run early
  std::function<void(double part)> progress;  // share played, 0 … 1
  // What the run waits for before it plays: "waiting for outlets: 2 of 4 joined, 18 s left".
  std::function<void(const std::string& what)> waiting = {};
  // Called at once if the source could not be made safe, with what a user must know. Also if run()
  // throws afterwards, so that another error cannot hide it. Must not throw.
  std::function<void(const std::string& what)> output_unknown = {};
  std::string station_text = {};  // content of the station file, for the record
};

// Blocks until the run has ended. A fault of the bench, a fault of an outlet or a stop does not
// throw: the record has the verdict ERROR and the reason. Throws profile::ConfigurationError if the
// firmware would refuse an outlet's settings, if the profile asks for what the station's slots
// cannot give, or if the source cannot keep the profile's tolerances; nothing has been energised or
// written then. Throws StationBusy if another bench uses the station. Throws record::StoreError if
// the record cannot be begun. If it cannot be continued, the run ends with that fault, and the file
// keeps what was stored. With options.writer, the outlets that are returned have no reports: read
// them from the file.
record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options);

}  // namespace gsbench::station
