
#include "noise_events.hpp"

#include <vector>

#include <gtest/gtest.h>

#include <outlet/event_detector.hpp>

namespace gs::outlet {
namespace {

// Steady at 50 Hz for as long as there is a history, then as given.
History history_of(const std::vector<float>& latest_hz) {
  History history;
  for (int i = 0; i < kHistoryLength; ++i) {
    push(history, 50.0F);
  }
  for (const float frequency_hz : latest_hz) {
    push(history, frequency_hz);
  }
  return history;
}

History falling(int drops, float drop_hz) {
  std::vector<float> latest;
  for (int i = 1; i <= drops; ++i) {
    latest.push_back(50.0F - drop_hz * static_cast<float>(i));
  }
  return history_of(latest);
}

TEST(EventDetector, FiveDropsThatComeToEnoughAreAnEvent) {
  EXPECT_TRUE(event_detected(five_drops(0.020F, 0.020F), falling(5, 0.005F)));
}

TEST(EventDetector, FiveDropsThatComeToLittleAreNone) {
  const History history = falling(5, 0.003F);
  EXPECT_FALSE(event_detected(five_drops(0.020F, 0.0F), history));
  EXPECT_TRUE(event_detected(five_drops(0.0F, 0.0F), history)) << "the paper's rule alone";
}

TEST(EventDetector, ALargeFallInFewerDropsIsNone) {
  const Settings settings = five_drops(0.020F, 0.018F);
  EXPECT_FALSE(event_detected(settings, falling(4, 0.1F)));
  EXPECT_FALSE(event_detected(settings, history_of({49.9F, 49.8F, 49.7F, 49.71F, 49.6F, 49.5F})));
  // No drop is one that stays.
  EXPECT_FALSE(event_detected(settings, history_of({49.9F, 49.8F, 49.7F, 49.7F, 49.6F, 49.5F})));
}

// A swing that comes down from above is back at the course, not below it.
TEST(EventDetector, DropsThatEndAtTheCourseBeforeAreNone) {
  const History history = history_of({50.05F, 50.04F, 50.03F, 50.02F, 50.01F, 50.0F});
  EXPECT_TRUE(event_detected(five_drops(0.014F, 0.0F), history));
  EXPECT_FALSE(event_detected(five_drops(0.014F, 0.018F), history));
}

TEST(EventDetector, DropsAreNotCountedAcrossAGap) {
  const Settings settings = five_drops(0.020F, 0.018F);
  History history = falling(3, 0.05F);
  note_gap(history);
  // Five drops follow on three before the gap; only the fifth after it has four steps behind it,
  // so it takes a sixth.
  for (int i = 4; i <= 8; ++i) {
    push(history, 50.0F - 0.05F * static_cast<float>(i));
    EXPECT_FALSE(event_detected(settings, history)) << i;
  }
  push(history, 50.0F - 0.05F * 9.0F);
  EXPECT_TRUE(event_detected(settings, history));
}

TEST(EventDetector, NothingIsDetectedBeforeThereIsABaseline) {
  History history;
  for (int i = 0; i < kBaselineAge + kBaselineLength - 6; ++i) {
    push(history, 50.0F);
  }
  for (int i = 1; i <= 5; ++i) {
    push(history, 50.0F - 0.05F * static_cast<float>(i));
  }
  EXPECT_FALSE(event_detected(five_drops(0.020F, 0.018F), history));
  push(history, 50.0F - 0.05F * 6.0F);
  EXPECT_TRUE(event_detected(five_drops(0.020F, 0.018F), history));
}

TEST(EventDetector, TheBaselineIsTheCourseBeforeTheFall) {
  History history;
  for (int i = 0; i < kHistoryLength; ++i) {
    push(history, 50.0F + 0.001F * static_cast<float>(i));
  }
  for (int i = 0; i < kBaselineAge; ++i) {
    push(history, 40.0F);
  }
  const Baseline before = baseline(history);
  // 16 entries that end with the 31st millihertz: their mean is 23.5 of them. Floats near 50 Hz are
  // 4 µHz apart.
  EXPECT_NEAR(before.frequency_hz, 50.0235F, 1e-5F);
  EXPECT_NEAR(before.rocof_hz_s, 0.001F / 0.016F, 1e-3F);
}

TEST(EventDetector, ALineThroughTheHistoryHasItsSlopeAndItsMiddle) {
  History history;
  for (int i = 0; i < 40; ++i) {
    push(history, 50.0F - 0.008F * static_cast<float>(i));
  }
  for (const int count : {2, 8, 32}) {
    const Line line = fit_line(history, 0, count);
    EXPECT_NEAR(line.slope_hz_s, -0.5F, 1e-3F) << count;
    EXPECT_NEAR(line.mean_hz, 50.0F - 0.008F * (39.0F - 0.5F * static_cast<float>(count - 1)),
                1e-5F)
        << count;
  }
}

// Five drops in a row happen by chance: once in 720 windows of independent noise, which would be
// 312 an hour, and more often on a tracker's smooth output.
TEST(EventDetector, InNoiseThePapersRuleAloneIsMetHundredsOfTimesAnHourAndOursNever) {
  constexpr double kHours = 0.5;
  const auto events = events_in_noise<2>({five_drops(0.0F, 0.0F), Settings{}}, kHours);
  EXPECT_GT(events[0], 312 * kHours);
  EXPECT_LT(events[0], 10000 * kHours);
  EXPECT_EQ(events[1], 0);
}

}  // namespace
}  // namespace gs::outlet
