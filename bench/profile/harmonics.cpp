#include "sections.hpp"

#include <algorithm>

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
      "order 0.001 … 1000, not 1, below half the sample rate; a whole number, or for "
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

}  // namespace gsbench::profile
