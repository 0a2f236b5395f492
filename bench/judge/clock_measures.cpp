#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

// A clock that was measured has an uncertainty.
bool has_clock(const Case& c) {
  return c.outlet.clock.drift_uncertainty_ppm > 0.0;
}

Reading drift(const Case& c) {
  const record::Clock& clock = c.outlet.clock;
  return has_clock(c) ? number(clock.drift_ppm, clock.drift_uncertainty_ppm)
                      : not_known("the outlet counts the source's own ticks");
}

Reading uncertainty(const Case& c) {
  return has_clock(c) ? number(c.outlet.clock.uncertainty_ms)
                      : not_known("the outlet counts the source's own ticks");
}

}  // namespace

Readings clock_readings() {
  return {
      {"clock.drift", drift},
      {"clock.uncertainty", uncertainty},
  };
}

}  // namespace gsbench::judge
