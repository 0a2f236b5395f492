#include "run_steps.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include <station/source_check.hpp>

namespace gsbench::station {
namespace {

constexpr const char* kTimeBase = "time base of the run";
constexpr const char* kTicks = "count the source's ticks";

// Of the time from a command, whose instant is one of this machine's clock (play.cpp), to an edge.
double command_uncertainty_ms(Station& station, const record::RunRecord& run) {
  const relay::RelaySense& sense = station.relay_sense();
  if (sense.count_at(std::chrono::steady_clock::now())) {
    return 1e3 * sense.alignment().uncertainty_between_ticks /
           static_cast<double>(run.sample_rate_hz);
  }
  const std::optional<source::HostClock> clock = station.source().host_clock();
  return run.bench_uncertainty.relay_sense_ms + (clock ? 1e3 * clock->uncertainty_s : 0.0);
}

}  // namespace

void note_source(const source::Played& played, Station& station, record::RunRecord& run) {
  const Deviations deviations = deviations_of(played);
  run.bench_uncertainty.frequency_mhz = deviations.frequency_mhz;
  run.bench_uncertainty.voltage_pct = deviations.voltage_pct;
  run.bench_uncertainty.time_ms = deviations.time_ms;
  run.source.name = station.source().limits().name;
  run.source.how = fmt::format("{}", fmt::join(played.how, "\n"));
  run.source.accuracy = station.source_accuracy();
}

// An edge is compared with an instant of the signal, so the error of the played signal adds to that
// of the edge. Both are bounds, and they are not independent: the sum is taken.
void note_relay_sense(Station& station, record::RunRecord& run) {
  run.bench_uncertainty.relay_sense_ms = 1e3 * station.relay_sense().alignment().uncertainty_ticks /
                                             static_cast<double>(run.sample_rate_hz) +
                                         run.bench_uncertainty.time_ms;
  run.bench_uncertainty.command_ms = command_uncertainty_ms(station, run);
}

void note_clocks(const Station& station, record::RunRecord& run) {
  run.clocks = {{"source", kTimeBase, run.bench_uncertainty.time_ms}};
  if (std::any_of(run.outlets.begin(), run.outlets.end(),
                  [](const record::OutletRecord& outlet) { return outlet.relay_sensed; })) {
    run.clocks.push_back(
        {kRelaySense, station.relay_aligned_by(), run.bench_uncertainty.relay_sense_ms});
  }
  bool any_in_step = false;
  for (const record::OutletRecord& outlet : run.outlets) {
    if (outlet.clock.drift_uncertainty_ppm > 0.0) {
      run.clocks.push_back({outlet.id, kAlignedByDips, outlet.clock.uncertainty_ms});
    } else {
      any_in_step = any_in_step || (station.outlets_count_ticks() && !outlet.link.empty());
    }
  }
  if (any_in_step) {
    run.clocks.push_back({"outlets", kTicks, 0.0});
  }
}

}  // namespace gsbench::station
