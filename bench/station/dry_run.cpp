#include "run_steps.hpp"

#include <limits>

#include <fmt/format.h>

#include <profile/load.hpp>
#include <station/dry_run.hpp>
#include <station/source_check.hpp>

namespace gsbench::station {

DryRun dry_run(const profile::Plan& plan, Station& station) {
  record::RunRecord run = prepare(plan, station);
  DryRun dry;
  dry.slots = assign(plan.outlets, station.slots());
  if (dry.slots.size() < plan.outlets.size()) {
    throw profile::ConfigurationError(fmt::format("{}: {} outlets; the station {} has {}",
                                                  plan.path, plan.outlets.size(), station.name(),
                                                  dry.slots.size()));
  }
  check_offered(plan, dry.slots);
  const PlayedSignal signal = signal_of(plan, dry.slots, station);
  dry.played = check_source(plan, signal, station.source());
  dry.source = station.source().limits().name;
  dry.accuracy = station.source_accuracy();
  dry.boot_s = std::chrono::duration<double>(station.answers_within()).count();
  const auto seconds = [&](std::int64_t ticks) {
    return static_cast<double>(ticks) / static_cast<double>(run.sample_rate_hz);
  };
  dry.markers_before_s = seconds(signal.lead_ticks());
  dry.run_s = seconds(run.duration_ticks);
  dry.markers_after_s = seconds(signal.total_ticks() - signal.lead_ticks() - run.duration_ticks);
  // The clocks of a run in which all outlets took part. Those of the outlets are measured later.
  note_source(dry.played, station, run);
  note_relay_sense(station, run);
  for (const Slot& slot : dry.slots) {
    record::OutletRecord& outlet = run.outlets.emplace_back();
    outlet.link = slot.link_id.value_or("");
    outlet.relay_sensed = slot.relay_channel.has_value();
  }
  note_clocks(station, run);
  for (const record::AlignedClock& clock : run.clocks) {
    dry.clocks.push_back(
        {clock.what, clock.aligned_by, clock.uncertainty_ms,
         clock.what == kRelaySense ? station.relay_sense().not_known_yet() : std::string()});
  }
  const bool own_clocks = signal.lead_ticks() > 0;
  if (own_clocks) {
    dry.clocks.push_back({"outlets", kAlignedByDips, std::numeric_limits<double>::quiet_NaN()});
  }
  return dry;
}

}  // namespace gsbench::station
