#include "sections.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {

using keys::Table;

keys::Key tone_keys() {
  return keys::tables(
      "tone",
      "Sines of a frequency of their own, added to the voltage: mains signalling, interharmonics "
      "of a fixed frequency, harmonics that are switched on. A tone that is keyed by `telegram` or "
      "`pulses_s` is on in its pulses alone; its phase runs on between them. Amplitude steps, "
      "flicker and phase steps do not act on tones.",
      {start_key(), duration_key(),
       keys::number("frequency_hz", "Hz", keys::above(0.0), "frequency of the tone")
           .permits("above 0, below half the sample rate")
           .require(),
       keys::number("amplitude_pct", "%", {0.0, 100.0, true},
                    "amplitude, relative to the nominal peak amplitude")
           .require(),
       keys::number("phase_deg", "degrees", keys::between(-360.0, 360.0),
                    "phase at the start; 0: rising from zero")
           .by_default(0.0),
       keys::text("telegram", "pulses of ripple control: `1` is on, `0` is off; blanks are ignored")
           .permits("`1`, `0` and blanks"),
       keys::number("bit_s", "s", keys::above(0.0),
                    "duration of each `1` and `0` of the telegram, at least one sample")
           .or_else("required with `telegram`"),
       keys::array("pulses_s",
                   keys::row({keys::number("from", "s", keys::at_least(0.0), ""),
                              keys::number("to", "s", keys::above(0.0), "")}),
                   "pulses in ascending order: times after `at_s` at which the tone is switched on "
                   "and off; pulses and gaps of at least one sample; not with `telegram`")});
}

namespace {

// Runs of ones.
std::vector<waveform::Pulse> telegram_pulses(const Table& table, const std::string& telegram,
                                             double sample_s) {
  if (!table.has("bit_s")) {
    table.refuse_missing("bit_s", "the duration of each bit of the telegram in seconds");
  }
  const double bit_s = table.number("bit_s");
  check_at_least_a_sample(table, table.at("bit_s"), "bit_s", bit_s, sample_s);
  std::vector<waveform::Pulse> pulses;
  double bits = 0.0;
  for (const char c : telegram) {
    if (c == ' ') {
      continue;
    }
    if (c != '0' && c != '1') {
      table.refuse("telegram",
                   fmt::format("telegram is \"{}\"; it must consist of 1, 0 and blanks", telegram));
    }
    if (c == '1' && !pulses.empty() && pulses.back().to_s == bits * bit_s) {
      pulses.back().to_s = (bits + 1.0) * bit_s;
    } else if (c == '1') {
      pulses.push_back({bits * bit_s, (bits + 1.0) * bit_s});
    }
    bits += 1.0;
  }
  if (pulses.empty()) {
    table.refuse("telegram", fmt::format("telegram is \"{}\"; it must have a 1", telegram));
  }
  return pulses;
}

std::vector<waveform::Pulse> listed_pulses(const Table& table, double sample_s) {
  std::vector<waveform::Pulse> pulses;
  double last_s = 0.0;
  for (const keys::Row& row : table.rows("pulses_s")) {
    const waveform::Pulse pulse = {row.values[0], row.values[1]};
    if (pulse.from_s < last_s) {
      table.refuse(row.at[0], fmt::format("from is {}; it must be at least {}, the end of the "
                                          "previous pulse",
                                          pulse.from_s, last_s));
    }
    if (pulse.to_s <= pulse.from_s) {
      table.refuse(row.at[1], fmt::format("to is {}; it must be above {}, the start of the pulse",
                                          pulse.to_s, pulse.from_s));
    }
    if (!pulses.empty() && pulse.from_s > last_s) {
      check_at_least_a_sample(table, row.at[0], "the gap before the pulse", pulse.from_s - last_s,
                              sample_s);
    }
    check_at_least_a_sample(table, row.at[1], "the pulse", pulse.to_s - pulse.from_s, sample_s);
    last_s = pulse.to_s;
    pulses.push_back(pulse);
  }
  return pulses;
}

// `limit_s`: end of the tone, after its start.
std::vector<waveform::Pulse> read_pulses(const Table& table, double limit_s, double sample_s) {
  const auto telegram = table.find_text("telegram");
  if (telegram && table.has("pulses_s")) {
    table.refuse("pulses_s", "both telegram and pulses_s are given; give only one");
  }
  if (!telegram && table.has("bit_s")) {
    table.refuse("bit_s", "bit_s is given without a telegram; give one, or omit bit_s");
  }
  std::vector<waveform::Pulse> pulses =
      telegram ? telegram_pulses(table, *telegram, sample_s) : listed_pulses(table, sample_s);
  constexpr double kRounding_s = 1e-9;
  if (!pulses.empty() && pulses.back().to_s > limit_s + kRounding_s) {
    table.refuse(telegram ? "telegram" : "pulses_s",
                 fmt::format("the last pulse ends {} s after at_s; it must end within {} s, as the "
                             "tone or the run does",
                             pulses.back().to_s, limit_s));
  }
  return pulses;
}

}  // namespace

std::vector<waveform::Tone> read_tones(const Table& signal, const RunTime& run) {
  const double limit_hz = 0.5 * static_cast<double>(run.sample_rate_hz);
  std::vector<waveform::Tone> tones;
  for (const Table& table : signal.tables("tone")) {
    const Span span = read_span(table, run, "tone");
    waveform::Tone tone = {span.at_s, span.duration_s, table.number("frequency_hz"),
                           table.number("amplitude_pct"), table.number("phase_deg")};
    tone.pulses =
        read_pulses(table, std::min(span.duration_s, run.end_s() - span.at_s), run.sample_s());
    if (tone.frequency_hz >= limit_hz) {
      table.refuse("frequency_hz",
                   fmt::format("frequency_hz is {}; it must be below {} (half of sample_rate_hz)",
                               tone.frequency_hz, limit_hz));
    }
    tones.push_back(std::move(tone));
  }
  return tones;
}

}  // namespace gsbench::profile
