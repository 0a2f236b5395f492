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
        continue;  // it was not spoken to: what it said may mean anything
      }
      capture::VoltageTrace voltage = capture.voltage_trace(outlet.id);
      voltage.window_samples = 2.0 * delay_s->second * rate_hz;
      const auto alignment = capture::align(voltage, markers, rate_hz);
      if (alignment) {
        clock = alignment->clock;
        outlet.clock = alignment->told;
      } else if (!run.interrupted) {
        note(outlet, "did not show the marks before the run in its voltage: its time is not known");
      }
    }
    capture.move_into(outlet, clock, run.duration_ticks);
  }
}

}  // namespace gsbench::station
