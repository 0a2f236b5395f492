#include "noise_events.hpp"

#include <gtest/gtest.h>

namespace gs::outlet {
namespace {

TEST(EventDetectorForHours, DetectsNoEventInFiveHoursOfNoise) {
  constexpr double kHours = 5.0;
  // Counterpart: at half of each limit, noise causes events.
  const auto events = events_in_noise<2>({Settings{}, five_drops(0.007F, 0.005F)}, kHours);
  EXPECT_EQ(events[0], 0);
  EXPECT_GT(events[1], 10);
}

}  // namespace
}  // namespace gs::outlet
