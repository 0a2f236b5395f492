
#include "noise_events.hpp"

#include <vector>

#include <gtest/gtest.h>

#include <outlet/event_detector.hpp>

namespace gs::outlet {
namespace {

// A whole history at 50 Hz, then the given frequencies.
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

TEST(EventDetector, FiveDropsWithASufficientSumAreAnEvent) {
  EXPECT_TRUE(event_detected(five_drops(0.020F, 0.020F), falling(5, 0.005F)));
}

TEST(EventDetector, FiveDropsWithASmallSumAreNotAnEvent) {
  const History history = falling(5, 0.003F);
  EXPECT_FALSE(event_detected(five_drops(0.020F, 0.0F), history));
  EXPECT_TRUE(event_detected(five_drops(0.0F, 0.0F), history)) << "the paper's rule alone";
}

TEST(EventDetector, ALargeFallInFewerDropsIsNotAnEvent) {
  const Settings settings = five_drops(0.020F, 0.018F);
  EXPECT_FALSE(event_detected(settings, falling(4, 0.1F)));
  EXPECT_FALSE(event_detected(settings, history_of({49.9F, 49.8F, 49.7F, 49.71F, 49.6F, 49.5F})));
  // An equal frequency is not a drop.
  EXPECT_FALSE(event_detected(settings, history_of({49.9F, 49.8F, 49.7F, 49.7F, 49.6F, 49.5F})));
}

// The return from a swing ends at the baseline, not below it.
TEST(EventDetector, DropsThatEndAtTheBaselineAreNotAnEvent) {
  const History history = history_of({50.05F, 50.04F, 50.03F, 50.02F, 50.01F, 50.0F});
  EXPECT_TRUE(event_detected(five_drops(0.014F, 0.0F), history));
  EXPECT_FALSE(event_detected(five_drops(0.014F, 0.018F), history));
}

TEST(EventDetector, DropsAreNotCountedAcrossAGap) {
  const Settings settings = five_drops(0.020F, 0.018F);
  History history = falling(3, 0.05F);
  note_gap(history);
  // Three drops before the gap and five entries after it are not enough: the five entries contain
  // only four drops. The sixth entry completes five drops.
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

TEST(EventDetector, TheBaselineIsTheFrequencyBeforeTheFall) {
  History history;
  for (int i = 0; i < kHistoryLength; ++i) {
    push(history, 50.0F + 0.001F * static_cast<float>(i));
  }
  for (int i = 0; i < kBaselineAge; ++i) {
    push(history, 40.0F);
  }
  const Baseline before = baseline(history);
  // The 16 entries from 16 to 31 mHz above 50 Hz have the mean 23.5 mHz. The spacing of floats near
  // 50 Hz is 4 µHz.
  EXPECT_NEAR(before.frequency_hz, 50.0235F, 1e-5F);
  EXPECT_NEAR(before.rocof_hz_s, 0.001F / 0.016F, 1e-3F);
}

TEST(EventDetector, AFittedLineHasTheSlopeAndTheMeanOfTheHistory) {
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

// Independent noise has five successive drops once in 720 windows, which is 312 an hour. A
// tracker's smooth output has them more often.
TEST(EventDetector, InNoiseThePapersRuleDetectsFalseEventsAndTheDefaultsNone) {
  constexpr double kHours = 0.5;
  const auto events = events_in_noise<2>({five_drops(0.0F, 0.0F), Settings{}}, kHours);
  EXPECT_GT(events[0], 1000 * kHours);
  EXPECT_LT(events[0], 10000 * kHours);
  EXPECT_EQ(events[1], 0);
}

}  // namespace
}  // namespace gs::outlet
