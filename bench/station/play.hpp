// Plays a run from its first tick to its last, and captures what the outlets do.
#pragma once

#include <capture/capture.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <station/played_signal.hpp>
#include <station/run.hpp>
#include <station/slot.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Throws BenchFault, where the source cannot play the signal too. `signal` outlives the playing.
void power_up(const PlayedSignal& signal, source::Source& source);

// Notes the faults of `outlets` as they come. Throws BenchFault. Returns false where it was stopped
// from outside.
bool play(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
          Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
          capture::Capture& capture);

}  // namespace gsbench::station
