#include <judge/catalogue.hpp>

namespace gsbench::judge {
namespace {

constexpr const char* kNeeds = "an outlet that counts its own samples";

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

std::vector<Measure> clock_measures() {
  return {
      {"clock.drift",
       "ppm",
       "By how much the outlet's sample clock is fast, from dips of the voltage before and after "
       "the run.",
       kNeeds,
       {},
       drift},
      {"clock.uncertainty",
       "ms",
       "How well the outlet's stamps are known on the run's time base, expanded (k = 2).",
       kNeeds,
       {},
       uncertainty},
  };
}

}  // namespace gsbench::judge
