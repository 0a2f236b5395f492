#include <outlet/event_detector.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

bool event_detected(const Settings& settings, const History& history) {
  const int drops = settings.event_drops;
  if (!covers_baseline(history) || history.unbroken <= drops) {
    return false;
  }
  for (int age = 0; age < drops; ++age) {
    if (!(at(history, age) < at(history, age + 1))) {
      return false;
    }
  }
  return at(history, drops) - at(history, 0) >= settings.event_drop_hz &&
         baseline(history).frequency_hz - at(history, 0) >= settings.event_departure_hz;
}

Baseline baseline(const History& history) {
  const Line line = fit_line(history, kBaselineAge, kBaselineLength);
  return {line.mean_hz, line.slope_hz_s};
}

}  // namespace gs::outlet
