// Samples that a board could not take.
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace gs::outlet {
namespace {

// 25 ms are missing from the samples: to a tracker that does not know, a leap of the phase.
TEST(LostSamples, GiveUpAnEventAndFindTheFrequencyAnew) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(500.0, 1.0);
  const test::Mains mains(spec);
  Config config;
  State state;
  ASSERT_TRUE(configure(mains.hardware(), config));
  ASSERT_EQ(apply(config, state, test::ieee24_settings()), SettingsError::kNone);
  std::vector<Report> reports;
  const auto keep = [&](const Report& report) { reports.push_back(report); };
  test::play(mains, 0, 11200, config, state, keep);  // 1.4 s: within the estimation
  ASSERT_EQ(reports.back().phase, Phase::kEstimating);
  reports.clear();
  lose_track(state);
  test::play(mains, 11400, 19400, config, state, keep);
  EXPECT_NE(reports.front().happened & kAborted, 0);
  EXPECT_EQ(reports.front().measurement.validity, Validity::kInvalid);
  EXPECT_EQ(reports.back().measurement.validity, Validity::kValid);
  for (const Report& report : reports) {
    EXPECT_EQ(report.happened & kDecision, 0) << "on what is left of an event";
    EXPECT_TRUE(report.relay_closed);
  }
}

}  // namespace
}  // namespace gs::outlet
