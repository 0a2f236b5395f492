// The decision rules of §5.5 as pure functions, shared by the outlet and by campaigns that simulate
// many outlets.
#pragma once

#include <outlet/settings.hpp>

namespace gs::outlet {

// Number of reports from the event's own to that of the decision by criterion (1), including both.
inline int reports_to_decision(const Settings& settings) {
  return settings.lse_samples + settings.ekf_samples;
}

// True if the load-shedding conditions were met often enough, §5.2.
inline bool enough_hits(int hits, int more_than) {
  return hits > more_than;
}

// ΔP_v, eq. (29): the power that all outlets together must shed.
inline float required_mw(float loss_mw, float threshold_mw) {
  const float excess_mw = loss_mw - threshold_mw;
  return excess_mw > 0.0f ? excess_mw : 0.0f;
}

// True if more is required than P^A, the power that less important outlets shed.
inline bool must_shed(float required_mw, float accumulated_mw) {
  return required_mw > accumulated_mw;
}

// Criterion (2): true after `samples` successive measurements below f^B. `below` is the count so
// far, kept by the caller. Both frequencies in Hz, or both as deviations from the same frequency.
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
