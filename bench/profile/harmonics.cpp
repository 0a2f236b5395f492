#include "sections.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include <profile/en50160.hpp>

namespace gsbench::profile {

using keys::Key;
using keys::Table;

Key harmonics_key() {
  constexpr double kHighestOrder = 1000.0;
  return keys::array(
      "harmonics",
      keys::row(
          {keys::number("order", "", keys::between(waveform::kLowestOrder, kHighestOrder), ""),
           keys::number("pct", "%", keys::between(0.0, 100.0), ""),
           keys::number("deg", "degrees", keys::between(-360.0, 360.0), "")}),
      "order 0.001 … 1000, not 1, below half the sample rate at every frequency of the run; a "
      "whole number, or for "
      "an interharmonic any other, such as 2.5; amplitude in % of the fundamental, "
      "0 … 100; phase ± 360: at a rising zero crossing of the fundamental, for an "
      "interharmonic at the first one (with `initial_phase_deg` 0, at the start)");
}

Key harmonic_set_key() {
  return keys::choice(
      "harmonic_set", {"en50160"},
      "orders 2 … 25, each at its limit of EN 50160, in addition to `harmonics`; total "
      "distortion 11.3 %, above the standard's limit of 8 %; phases are multiples of "
      "the golden angle");
}

std::vector<waveform::Harmonic> read_harmonics(const Table& signal, double nominal_hz,
                                               double rate_hz) {
  std::vector<waveform::Harmonic> harmonics;
  const auto add = [&](const waveform::Harmonic& harmonic, keys::Position at) {
    const auto same = [&](const waveform::Harmonic& other) {
      return other.order == harmonic.order;
    };
    if (std::any_of(harmonics.begin(), harmonics.end(), same)) {
      signal.refuse(at, fmt::format("harmonic order {} is given twice; give each order once, "
                                    "including those of harmonic_set",
                                    harmonic.order));
    }
    if (harmonic.order == 1.0) {
      signal.refuse(at, "harmonic order is 1, the fundamental; it must be another");
    }
    if (harmonic.order * nominal_hz >= rate_hz / 2.0) {
      signal.refuse(at,
                    fmt::format("harmonic order {} is at {} Hz; it must be below {} Hz (half of "
                                "sample_rate_hz)",
                                harmonic.order, harmonic.order * nominal_hz, rate_hz / 2.0));
    }
    harmonics.push_back(harmonic);
  };
  if (signal.has("harmonic_set")) {
    for (const waveform::Harmonic& harmonic : en50160_harmonics()) {
      add(harmonic, signal.at("harmonic_set"));
    }
  }
  for (const keys::Row& row : signal.rows("harmonics")) {
    add({row.values[0], row.values[1], row.values[2]}, row.at[0]);
  }
  return harmonics;
}

namespace {

struct Highest {
  double t_s;
  double frequency_hz;
};

// Between points the frequency is monotone, so that the highest is at one of them. A response to
// losses and an oscillation of at most 5 Hz are searched: a step misses less than 2 · 10⁻³ of the
// amplitude of an oscillation.
Highest highest_frequency(const Stimulus& stimulus, const waveform::ReferenceSignal& reference) {
  Highest highest = {0.0, reference.frequency_hz(0.0)};
  const auto take = [&](double t_s) {
    const double frequency_hz = reference.frequency_hz(t_s);
    if (frequency_hz > highest.frequency_hz) {
      highest = {t_s, frequency_hz};
    }
  };
  for (const double t_s : reference.corners_s()) {
    take(std::clamp(t_s, 0.0, stimulus.duration_s));
  }
  const double step_s = stimulus.oscillations.empty() ? 0.01 : 0.004;
  if (!stimulus.losses.empty() || !stimulus.oscillations.empty()) {
    const auto steps = static_cast<std::int64_t>(stimulus.duration_s / step_s);
    for (std::int64_t i = 0; i <= steps; ++i) {
      take(static_cast<double>(i) * step_s);
    }
  }
  return highest;
}

}  // namespace

void check_spectrum(const Table& signal, const Stimulus& stimulus,
                    const waveform::ReferenceSignal& reference) {
  const std::vector<waveform::Harmonic>& harmonics = stimulus.signal.harmonics;
  const std::vector<waveform::Flicker>& flickers = stimulus.signal.flickers;
  if (harmonics.empty() && flickers.empty()) {
    return;
  }
  const Highest highest = highest_frequency(stimulus, reference);
  const double limit_hz = 0.5 * static_cast<double>(stimulus.sample_rate_hz);
  // As read_harmonics(): those of the set come first.
  const std::size_t of_set = signal.has("harmonic_set") ? en50160_harmonics().size() : 0;
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const double frequency_hz = harmonics[i].order * highest.frequency_hz;
    if (frequency_hz >= limit_hz) {
      signal.refuse(
          i < of_set ? signal.at("harmonic_set") : signal.rows("harmonics").at(i - of_set).at[0],
          fmt::format("harmonic order {} is at {:.6g} Hz at {:.6g} s, where the frequency "
                      "is {:.6g} Hz; it must be below {} Hz (half of sample_rate_hz)",
                      harmonics[i].order, frequency_hz, highest.t_s, highest.frequency_hz,
                      limit_hz));
    }
  }
  // Flicker has side bands on both sides of the fundamental and of each harmonic.
  double order = 1.0;
  for (const waveform::Harmonic& harmonic : harmonics) {
    order = std::max(order, harmonic.order);
  }
  double side_band_hz = order * highest.frequency_hz;
  for (std::size_t i = 0; i < flickers.size(); ++i) {
    side_band_hz += flickers[i].frequency_hz;
    if (side_band_hz >= limit_hz) {
      const Table table = signal.tables("flicker").at(i);
      table.refuse(
          table.has("frequency_hz") ? "frequency_hz" : "changes_per_minute",
          fmt::format(
              "{} has a side band at {:.6g} Hz at {:.6g} s by the flicker; it must be below "
              "{} Hz (half of sample_rate_hz)",
              order > 1.0 ? fmt::format("harmonic order {}", order) : "the fundamental",
              side_band_hz, highest.t_s, limit_hz));
    }
  }
}

}  // namespace gsbench::profile
