#include "sections.hpp"

namespace gsbench::profile {

using keys::Table;

keys::Key oscillation_keys() {
  return keys::tables(
      "oscillation",
      "Inter-area oscillations: sines laid over the frequency that the outlets see. The grid's own "
      "frequency, for example its nadir, is that without them.",
      {start_key(), duration_key(),
       keys::number(
           "frequency_hz", "Hz",
           keys::between(waveform::kSlowestOscillation_hz, waveform::kFastestOscillation_hz),
           "frequency of the oscillation")
           .require(),
       keys::number("amplitude_mhz", "mHz", {0.0, 1e3 * waveform::kLargestOscillation_hz, true},
                    "peak of the deviation")
           .require(),
       keys::number("phase_deg", "degrees", keys::between(-360.0, 360.0),
                    "phase at the start; 0: the frequency rises without a step, 180: it falls; "
                    "otherwise it starts with a step")
           .by_default(0.0)});
}

std::vector<waveform::Oscillation> read_oscillations(const Table& signal, const RunTime& run) {
  std::vector<waveform::Oscillation> oscillations;
  for (const Table& table : signal.tables("oscillation")) {
    const Span span = read_span(table, run, "oscillation");
    waveform::Oscillation oscillation;
    oscillation.at_s = span.at_s;
    oscillation.duration_s = span.duration_s;
    oscillation.frequency_hz = table.number("frequency_hz");
    oscillation.amplitude_hz = 1e-3 * table.number("amplitude_mhz");
    oscillation.phase_deg = table.number("phase_deg");
    oscillations.push_back(oscillation);
  }
  return oscillations;
}

}  // namespace gsbench::profile
