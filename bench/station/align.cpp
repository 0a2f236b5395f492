#include "faults.hpp"
#include "run_steps.hpp"

namespace gsbench::station {

void align(const Station& station, const capture::Markers& markers, capture::Capture& capture,
           record::RunRecord& run) {
  const auto rate_hz = static_cast<double>(run.sample_rate_hz);
  for (record::OutletRecord& outlet : run.outlets) {
    capture::OutletClock clock;
    if (!outlet.link.empty() && !station.outlets_count_ticks()) {
      const auto delay_s = outlet.settings.find("voltage_delay_s");
      if (delay_s == outlet.settings.end()) {
        continue;  // it was sent no settings, so its reports cannot be interpreted
      }
      capture::VoltageTrace voltage = capture.voltage_trace(outlet.id);
      voltage.window_samples = 2.0 * delay_s->second * rate_hz;
      const auto alignment = capture::align(voltage, markers, rate_hz);
      if (alignment) {
        clock = alignment->clock;
        outlet.clock = alignment->measured;
        // The dips are as early or late as all that the source plays.
        outlet.clock.uncertainty_ms += run.bench_uncertainty.time_ms;
      } else if (!run.interrupted) {
        note(outlet,
             "did not report the marker dips played before the run: its time stamps cannot be "
             "aligned");
      }
    }
    capture.move_into(outlet, clock, run.duration_ticks);
  }
}

}  // namespace gsbench::station
