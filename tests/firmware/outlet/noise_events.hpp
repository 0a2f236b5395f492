// Counts the events that several detectors find in the same tracker output.
#pragma once

#include <firmware_test/mains.hpp>

#include <array>

#include <outlet/event_detector.hpp>

namespace gs::outlet {

inline Settings five_drops(float drop_hz, float departure_hz) {
  Settings settings;
  settings.event_drops = 5;
  settings.event_drop_hz = drop_hz;
  settings.event_departure_hz = departure_hz;
  return settings;
}

// Number of events by each set of rules in the same hours of 1 % noise.
template <std::size_t kRules>
std::array<int, kRules> events_in_noise(const std::array<Settings, kRules>& rules, double hours) {
  test::PlayedOutlet outlet({test::steady(50.0, 50.0), {}, 1.0});
  std::array<int, kRules> events{};
  std::array<bool, kRules> under_way{};
  outlet.play(3600.0 * hours, [&](const Report&) {
    for (std::size_t i = 0; i < kRules; ++i) {
      const bool detected = event_detected(rules[i], outlet.state.history);
      events[i] += detected && !under_way[i] ? 1 : 0;
      under_way[i] = detected;
    }
  });
  return events;
}

}  // namespace gs::outlet
