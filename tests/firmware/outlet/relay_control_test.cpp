// Time delay and restoration of the relay.
#include <firmware_test/settings.hpp>

#include <set>

#include <gtest/gtest.h>

#include <outlet/relay_control.hpp>

namespace gs::outlet {
namespace {

Settings settings_with(float delay_s, float restore_hz) {
  Settings settings = test::ieee24_settings();
  settings.delay_s = delay_s;
  settings.restore_hz = restore_hz;
  settings.restore_dwell_s = 2.0F;
  settings.restore_spread_s = 3.0F;
  return settings;
}

// Reports until the relay changes, at most `most`.
int reports_to_change(const Settings& settings, RelayState& relay, float frequency_hz, int most) {
  for (int n = 1; n <= most; ++n) {
    if (run(settings, relay, frequency_hz) != RelayChange::kNone) {
      return n;
    }
  }
  return -1;
}

TEST(RelayControl, OpensAtOnceWithoutADelay) {
  RelayState relay;
  EXPECT_TRUE(open(settings_with(0.0F, 0.0F), relay, Cause::kLoss, 49.6F));
  EXPECT_FALSE(relay.closed);
  EXPECT_EQ(relay.cause, Cause::kLoss);
  EXPECT_FALSE(open(settings_with(0.0F, 0.0F), relay, Cause::kFrequency, 49.0F));
  EXPECT_EQ(relay.cause, Cause::kLoss) << "it is open already";
}

TEST(RelayControl, OpensAfterTheDelay) {
  const Settings settings = settings_with(0.5F, 0.0F);
  RelayState relay;
  EXPECT_FALSE(open(settings, relay, Cause::kLoss, 49.6F));
  EXPECT_TRUE(relay.closed);
  EXPECT_EQ(reports_to_change(settings, relay, 49.6F, 100), 32) << "0.5 s, rounded up to 16 ms";
  EXPECT_FALSE(relay.closed);
}

TEST(RelayControl, ACommandReplacesADelayedDecision) {
  const Settings settings = settings_with(0.5F, 0.0F);
  RelayState relay;
  open(settings, relay, Cause::kLoss, 49.6F);
  EXPECT_FALSE(command(relay, true));
  EXPECT_EQ(reports_to_change(settings, relay, 49.6F, 100), -1);
  EXPECT_TRUE(command(relay, false));
  EXPECT_EQ(relay.cause, Cause::kCommand);
}

TEST(RelayControl, RestoresAfterDwellAndARandomTime) {
  const Settings settings = settings_with(0.0F, 49.9F);
  std::set<int> times;
  for (int outlet = 0; outlet < 50; ++outlet) {
    RelayState relay;
    // The noise of the measurement differs.
    open(settings, relay, Cause::kLoss, 49.6F + 1e-5F * static_cast<float>(outlet));
    EXPECT_EQ(reports_to_change(settings, relay, 49.89F, 1000), -1) << "too low";
    const int reports = reports_to_change(settings, relay, 49.95F, 1000);
    EXPECT_GE(reports, 125) << "2 s";
    EXPECT_LE(reports, 314) << "5 s, rounded up";
    EXPECT_TRUE(relay.closed);
    EXPECT_EQ(relay.cause, Cause::kNone);
    times.insert(reports);
  }
  EXPECT_GT(times.size(), 30U);
  EXPECT_GT(*times.rbegin() - *times.begin(), 100);
}

TEST(RelayControl, RestorationBeginsAgainIfTheFrequencyFallsOrIsNotMeasured) {
  const Settings settings = settings_with(0.0F, 49.9F);
  for (const float interruption_hz : {49.8F, kNotANumber}) {
    RelayState relay;
    open(settings, relay, Cause::kFrequency, 49.0F);
    EXPECT_EQ(reports_to_change(settings, relay, 49.95F, 120), -1);
    EXPECT_EQ(run(settings, relay, interruption_hz), RelayChange::kNone);
    EXPECT_GE(reports_to_change(settings, relay, 49.95F, 1000), 125);
  }
}

TEST(RelayControl, DoesNotRestoreWhatACommandOpenedOrWithoutTheSetting) {
  RelayState relay;
  command(relay, false);
  EXPECT_EQ(reports_to_change(settings_with(0.0F, 49.9F), relay, 50.0F, 1000), -1);
  relay = RelayState{};
  open(settings_with(0.0F, 49.9F), relay, Cause::kLoss, 49.6F);
  EXPECT_FALSE(command(relay, false)) << "it is open already";
  EXPECT_EQ(reports_to_change(settings_with(0.0F, 49.9F), relay, 50.0F, 1000), -1);
  relay = RelayState{};
  open(settings_with(0.0F, 0.0F), relay, Cause::kLoss, 49.6F);
  EXPECT_EQ(reports_to_change(settings_with(0.0F, 0.0F), relay, 50.0F, 1000), -1);
}

}  // namespace
}  // namespace gs::outlet
