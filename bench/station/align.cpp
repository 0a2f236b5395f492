#include "align.hpp"

#include "faults.hpp"

namespace gsbench::station {
namespace {

void align(std::size_t i, const Station& station, const capture::Markers& markers,
           capture::Capture& capture, record::RunRecord& run) {
  record::OutletRecord& outlet = run.outlets[i];
  outlet.relay_sensed = station.relay_channel(i).has_value();
  capture::OutletClock clock;
  if (!station.outlets_count_ticks()) {
    const auto delay_s = outlet.settings.find("voltage_delay_s");
    if (delay_s == outlet.settings.end()) {
      return;  // it was not spoken to: what it said may mean anything
    }
    const auto rate_hz = static_cast<double>(run.sample_rate_hz);
    capture::VoltageTrace voltage = capture.voltage_trace(i);
    voltage.window_samples = 2.0 * delay_s->second * rate_hz;
    const auto alignment = capture::align(voltage, markers, rate_hz);
    if (alignment) {
      clock = alignment->clock;
      outlet.clock = alignment->told;
    } else if (!run.interrupted) {
      note(outlet, "did not show the marks before the run in its voltage: its time is not known");
    }
  }
  capture.move_into(i, clock, run.duration_ticks, outlet);
}

}  // namespace

void align(const Station& station, const capture::Markers& markers, capture::Capture& capture,
           record::RunRecord& run) {
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    align(i, station, markers, capture, run);
  }
}

}  // namespace gsbench::station
