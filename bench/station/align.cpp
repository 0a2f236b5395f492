#include "faults.hpp"
#include "run_steps.hpp"

namespace gsbench::station {

bool has_own_clock(const Station& station, const record::OutletRecord& outlet) {
  return !outlet.link.empty() && !station.outlets_count_ticks();
}

bool align(const capture::Markers& markers, record::Store& store, std::size_t i,
           record::RunRecord& run) {
  record::OutletRecord& outlet = run.outlets[i];
  const auto delay_s = outlet.settings.find("voltage_delay_s");
  if (delay_s == outlet.settings.end()) {
    return true;  // it was sent no settings, so its reports cannot be interpreted
  }
  const auto rate_hz = static_cast<double>(run.sample_rate_hz);
  capture::EdgeReadings edges(markers.level, 2.0 * delay_s->second * rate_hz);
  store.read_reports(i, [&](const record::Reports& piece) {
    edges.add(piece.trace.tick, piece.trace.voltage_pu);
  });
  const auto clock = capture::align(edges.trace(), markers, rate_hz);
  if (clock) {
    outlet.clock = *clock;
    // The dips are as early or late as all that the source plays.
    outlet.clock.uncertainty_ms += run.bench_uncertainty.time_ms;
  }
  return clock.has_value();
}

}  // namespace gsbench::station
