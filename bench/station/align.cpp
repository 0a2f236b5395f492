#include "faults.hpp"
#include "run_steps.hpp"

namespace gsbench::station {

bool has_own_clock(const Station& station, const record::OutletRecord& outlet) {
  return !outlet.link.empty() && !station.outlets_count_ticks();
}

bool align(const capture::Markers& markers, const record::MeasurementTrace& reports,
           std::int64_t sample_rate_hz, record::OutletRecord& outlet) {
  const auto delay_s = outlet.settings.find("voltage_delay_s");
  if (delay_s == outlet.settings.end()) {
    return true;  // it was sent no settings, so its reports cannot be interpreted
  }
  const auto rate_hz = static_cast<double>(sample_rate_hz);
  const auto clock = capture::align(
      {reports.tick, reports.voltage_pu, 2.0 * delay_s->second * rate_hz}, markers, rate_hz);
  if (clock) {
    outlet.clock = *clock;
  }
  return clock.has_value();
}

}  // namespace gsbench::station
