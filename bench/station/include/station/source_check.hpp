// Whether a source can play a plan accurately enough. Used by a run before it energises anything,
// and by `run --dry-run`.
#pragma once

#include <string>

#include <profile/plan.hpp>
#include <source/source.hpp>
#include <station/played_signal.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// The deviations in the units of the tolerances.
struct Deviations {
  double frequency_mhz = 0.0;
  // Of the nominal peak amplitude: the planned waveform, and once the accuracy of the amplitude.
  double voltage_pct = 0.0;
  double time_ms = 0.0;
};
Deviations deviations_of(const source::Played& played);

// Which deviations exceed the tolerances, with the numbers; empty if none does.
std::string beyond(const profile::Tolerances& tolerances, const Deviations& deviations);

// What the source would play. Does not touch the output. Throws profile::ConfigurationError if the
// source refuses the signal or exceeds the plan's tolerances.
source::Played check_source(const profile::Plan& plan, const PlayedSignal& signal,
                            const source::Source& source);

// The signal of a run on these slots. Markers are played if an outlet has a sample clock of its own
// and a link.
PlayedSignal signal_of(const profile::Plan& plan, const std::vector<Slot>& slots,
                       const Station& station);

}  // namespace gsbench::station
