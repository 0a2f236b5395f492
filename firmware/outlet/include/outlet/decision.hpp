// What an outlet decides by, §5.5, as pure functions: for the outlet, and for campaigns that play
// many of them.
#pragma once

#include <outlet/settings.hpp>

namespace gs::outlet {

// An event's reports, its own among them, until criterion (1) is decided.
inline int reports_to_decision(const Settings& settings) {
  return settings.lse_samples + settings.ekf_samples;
}

// The load-shedding conditions were met often enough, §5.2.
inline bool enough_hits(int hits, int more_than) {
  return hits > more_than;
}

// ΔP_v, eq. (29): what all outlets together must shed.
inline float required_mw(float loss_mw, float threshold_mw) {
  const float excess_mw = loss_mw - threshold_mw;
  return excess_mw > 0.0f ? excess_mw : 0.0f;
}

// More is required than less important outlets shed already, P^A.
inline bool must_shed(float required_mw, float accumulated_mw) {
  return required_mw > accumulated_mw;
}

// Criterion (2): `samples` successive measurements below f^B, of which `below` counts the newest,
// up to that many. Both frequencies in Hz, or both as deviations from the same one.
inline bool stays_below(float frequency_hz, float switch_off_hz, std::uint8_t samples,
                        std::uint8_t& below) {
  if (!(frequency_hz < switch_off_hz)) {
    below = 0;
  } else if (below < samples) {
    ++below;
  }
  return below >= samples;
}

}  // namespace gs::outlet
