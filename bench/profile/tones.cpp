#include "sections.hpp"

#include <fmt/format.h>

namespace gsbench::profile {

using keys::Table;

keys::Key tone_keys() {
  return keys::tables(
      "tone",
      "Sines of a frequency of their own, added to the voltage: mains signalling, interharmonics, "
      "harmonics that are switched on; flicker, as a tone on each side of nominal. Amplitude and "
      "phase steps do not act on them.",
      {keys::number("at_s", "s", keys::at_least(0.0), "start")
           .permits("0 … before the end of the run")
           .by_default(0.0),
       keys::number("duration_s", "s", keys::above(0.0), "duration")
           .permits("above 0, ending within the run")
           .or_else("to the end"),
       keys::number("frequency_hz", "Hz", keys::above(0.0), "frequency of the tone")
           .permits("above 0, below half the sample rate")
           .require(),
       keys::number("amplitude_pct", "%", {0.0, 100.0, true},
                    "amplitude, relative to the nominal peak amplitude")
           .require(),
       keys::number("phase_deg", "degrees", keys::between(-360.0, 360.0),
                    "phase at the start; 0: rising from zero")
           .by_default(0.0)});
}

std::vector<waveform::Tone> read_tones(const Table& signal, double duration_s,
                                       std::int64_t sample_rate_hz) {
  const double limit_hz = 0.5 * static_cast<double>(sample_rate_hz);
  std::vector<waveform::Tone> tones;
  for (const Table& table : signal.tables("tone")) {
    const double at_s = table.number("at_s", within_run(duration_s));
    const waveform::Tone tone = {at_s, read_duration_s(table, at_s, duration_s, "tone"),
                                 table.number("frequency_hz"), table.number("amplitude_pct"),
                                 table.number("phase_deg")};
    if (tone.frequency_hz >= limit_hz) {
      table.refuse("frequency_hz",
                   fmt::format("frequency_hz is {}; it must be below {} (half of sample_rate_hz)",
                               tone.frequency_hz, limit_hz));
    }
    tones.push_back(tone);
  }
  return tones;
}

}  // namespace gsbench::profile
