// The steps of a run, in the order in which run.cpp calls them.
#pragma once

#include "boot.hpp"
#include "recorder.hpp"

#include <string>
#include <vector>

#include <capture/capture.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <station/played_signal.hpp>
#include <station/run.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Returns a record with its head: the stimulus, the station and the versions. Throws
// profile::ConfigurationError if the firmware would refuse an outlet's settings, which is an error
// in the profile. No device has been used then.
record::RunRecord prepare(const profile::Plan& plan, Station& station);

std::string utc_now();  // ISO 8601, to the second

// Versions of the compiler, the libraries and the system: lines.
std::string software();

// `message` as the record keeps it.
record::Sent sent(gs::wire::Downlink message, std::int64_t tick);

// Assigns one slot to each outlet of a plan, in the plan's order. An outlet gets the slot whose
// serial number is its id. If there is none, it gets the next free slot whose serial number is not
// an id in the plan. The result is shorter than `outlets` if there are too few slots.
std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots);

// Refuses limits and commands that need a link for an outlet whose slot has none, and such an
// outlet without any limit. Throws profile::ConfigurationError.
void check_offered(const profile::Plan& plan, const std::vector<Slot>& slots);

// The relay sense among the clocks of a run.
constexpr const char* kRelaySense = "relay sense";

// What the source states about the signal that it plays.
void note_source(const source::Played& played, Station& station, record::RunRecord& run);

// The uncertainties of the relay sense, which may have grown during the run.
void note_relay_sense(Station& station, record::RunRecord& run);

// Waits for the outlets in `slots` and sends them their settings. The link is open and the source
// is energised. Slot i is for outlet i of the plan. An outlet that does not join, is faulty, has
// another serial number than its slot requires or the wrong sample rate is excluded with that
// fault. An outlet without a link takes part without
// settings. Throws BenchFault if there are too few slots, and Stopped.
std::vector<record::OutletRecord> claim(const profile::Plan& plan, const std::vector<Slot>& slots,
                                        Station& station, Boot& boot);

// Plays the whole signal and notes the faults of `outlets`. Returns false if `options.stop` ended
// it. Throws BenchFault and record::StoreError.
bool play(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
          Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
          capture::Capture& capture, Recorder& recorder);

// The outlet counts its own samples, not the ticks of the source.
bool has_own_clock(const Station& station, const record::OutletRecord& outlet);

// Measures the clock of outlet i of the run by the marker dips in its stored reports. Returns
// false, and leaves the clock as it is, if they are not found. An outlet that was sent no settings
// is not measured. Throws record::StoreError.
bool align(const capture::Markers& markers, record::Store& store, std::size_t i,
           record::RunRecord& run);

// Aligns and judges each outlet as the store has it. Without `keeps_reports`, the outlets of `run`
// keep their results only, the reports stay in the store, and the digest of the content is noted.
// Throws record::StoreError.
void judge_stored(const profile::Plan& plan, const Station& station, const PlayedSignal& signal,
                  record::Store& store, bool keeps_reports, record::RunRecord& run);

constexpr const char* kAlignedByDips = "voltage dips before and after the run";

// Notes how each clock was aligned. Called after align().
void note_clocks(const Station& station, record::RunRecord& run);

}  // namespace gsbench::station
