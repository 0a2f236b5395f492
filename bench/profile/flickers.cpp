#include "sections.hpp"

#include <fmt/format.h>

namespace gsbench::profile {

using keys::Table;

keys::Key flicker_keys() {
  return keys::tables(
      "flicker",
      "Modulation of the amplitude, as in the test signals of IEC 61000-4-15. It acts on the "
      "fundamental and its harmonics. Several multiply.",
      {start_key(), duration_key(),
       keys::choice("shape", {"sine", "rectangle"},
                    "`sine` starts at the mean amplitude and rises; `rectangle` starts with the "
                    "higher amplitude")
           .by_default("sine"),
       keys::number("depth_pct", "%", {0.0, 100.0, true},
                    "ΔV/V: difference of the highest and lowest amplitude, relative to their mean, "
                    "which is the amplitude without flicker")
           .require(),
       keys::number("frequency_hz", "Hz", keys::above(0.0), "frequency of the modulation")
           .permits("above 0; with the highest harmonic, below half the sample rate")
           .or_else("required, or `changes_per_minute`"),
       keys::number("changes_per_minute", "1/min", keys::above(0.0),
                    "changes of the voltage, two in each period of the modulation")
           .permits("above 0; likewise")
           .or_else("required, or `frequency_hz`")});
}

std::vector<waveform::Flicker> read_flickers(const Table& signal, const RunTime& run) {
  constexpr double kChangesPerMinute = 120.0;  // at 1 Hz
  const double limit_hz = 0.5 * static_cast<double>(run.sample_rate_hz);
  std::vector<waveform::Flicker> flickers;
  for (const Table& table : signal.tables("flicker")) {
    const Span span = read_span(table, run, "flicker");
    const auto frequency_hz = table.find_number("frequency_hz");
    const auto changes = table.find_number("changes_per_minute");
    if (frequency_hz && changes) {
      table.refuse("changes_per_minute",
                   "both frequency_hz and changes_per_minute are given; give only one");
    }
    if (!frequency_hz && !changes) {
      table.refuse_missing("frequency_hz", "frequency_hz or changes_per_minute");
    }
    const waveform::Flicker flicker = {
        span.at_s, span.duration_s, frequency_hz ? *frequency_hz : *changes / kChangesPerMinute,
        table.number("depth_pct"), table.text("shape") == "rectangle"};
    if (flicker.frequency_hz >= limit_hz) {
      table.refuse(
          frequency_hz ? "frequency_hz" : "changes_per_minute",
          fmt::format("the frequency of the flicker is {} Hz; it must be below {} Hz (half "
                      "of sample_rate_hz)",
                      flicker.frequency_hz, limit_hz));
    }
    flickers.push_back(flicker);
  }
  return flickers;
}

}  // namespace gsbench::profile
