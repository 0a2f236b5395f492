// The steps of a run in their order (run.cpp), and what they share.
#pragma once

#include <string>
#include <vector>

#include <capture/capture.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <station/played_signal.hpp>
#include <station/run.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// The head of the record: what is to be played, where and with what. Throws
// profile::ConfigurationError where the firmware would refuse the settings of an outlet, before
// anything is touched: that is the profile's mistake.
record::RunRecord prepare(const profile::Plan& plan, Station& station);

std::string utc_now();  // ISO 8601, to the second

// One for each outlet of a plan, in the plan's order: the slot with the outlet's id for its serial
// number, else the next that no outlet of the plan names. Fewer than outlets where there are no
// more.
std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots);

// Each outlet of the plan gets one of the station's, with its settings: in the plan's order, each
// in its slot. One that does not answer, was found at fault, or samples otherwise than the plan
// needs, has that fault and no settings; one without a link has no settings either. Throws
// BenchFault where there are too few slots.
std::vector<record::OutletRecord> claim(const profile::Plan& plan, const std::vector<Slot>& slots,
                                        Station& station);

// From the first tick to the last. Notes the faults of `outlets` as they come. Throws BenchFault.
// Returns false where it was stopped from outside.
bool play(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
          Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
          capture::Capture& capture);

// Brings what outlets said onto the run's time base, into their records. `markers`: the dips that
// were played around the run, by which the counts of outlets that count their own samples are
// aligned.
void align(const Station& station, const capture::Markers& markers, capture::Capture& capture,
           record::RunRecord& run);

}  // namespace gsbench::station
