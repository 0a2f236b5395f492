#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

constexpr const char* kNoClock = "the outlet counts the source's ticks and has no clock of its own";

bool was_measured(const Case& c) {
  return c.outlet.clock.drift_uncertainty_ppm > 0.0;
}

Reading drift(const Case& c) {
  const record::Clock& clock = c.outlet.clock;
  return was_measured(c) ? number(clock.drift_ppm, clock.drift_uncertainty_ppm)
                         : not_known(kNoClock);
}

Reading uncertainty(const Case& c) {
  return was_measured(c) ? number(c.outlet.clock.uncertainty_ms) : not_known(kNoClock);
}

}  // namespace

Readings clock_readings() {
  return {
      {"clock.drift", drift},
      {"clock.uncertainty", uncertainty},
  };
}

}  // namespace gsbench::judge
