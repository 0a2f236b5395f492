// Criterion (1) of §5.5 on a played loss of 500 MW: what it takes, each part withheld in turn.
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <algorithm>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace gs::outlet {
namespace {

constexpr double kLossS = 1.0;
constexpr double kDurationS = 2.5;

using Reports = std::vector<Report>;

Reports reports_of_loss(double power_mw, const Settings& settings) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(power_mw, kLossS);
  return test::reports_of(test::Mains(spec), kDurationS, settings);
}

const Report* first_with(const Reports& reports, Happened what) {
  const auto found = std::find_if(reports.begin(), reports.end(), [what](const Report& report) {
    return (report.happened & what) != 0;
  });
  return found == reports.end() ? nullptr : &*found;
}

int count_of(const Reports& reports, Happened what) {
  return static_cast<int>(
      std::count_if(reports.begin(), reports.end(),
                    [what](const Report& report) { return (report.happened & what) != 0; }));
}

struct Decision {
  Report report;
  bool shed = false;
};

// The one decision after a loss of 500 MW, with the settings changed as told.
Decision decision_with(const std::function<void(Settings&)>& change) {
  Settings settings = test::ieee24_settings();
  change(settings);
  const Reports reports = reports_of_loss(500.0, settings);
  EXPECT_EQ(count_of(reports, kEvent), 1);
  EXPECT_EQ(count_of(reports, kDecision), 1);
  const Report* decision = first_with(reports, kDecision);
  if (decision == nullptr) return {};
  EXPECT_EQ(reports.back().relay_closed, decision->relay_closed) << "nothing else acts";
  return {*decision, !decision->relay_closed && decision->cause == Cause::kLoss};
}

TEST(Decision, ShedsWhereConditionsEstimateAndPlaceInTheOrderAllSaySo) {
  const Decision d = decision_with([](Settings&) {});
  EXPECT_TRUE(d.shed);
  EXPECT_NE(d.report.happened & kRelay, 0);
  EXPECT_EQ(d.report.trust, Trust::kTrusted);
  EXPECT_GT(d.report.hits, 20);
  // Required: within 4 % of 960 ms and of the loss, less the threshold of 351.92 MW.
  EXPECT_NEAR(d.report.loss_mw, 500.0F, 20.0F);
  EXPECT_NEAR(d.report.required_mw, d.report.loss_mw - 351.92F, 0.1F);
  EXPECT_LE(test::report_s(d.report), kLossS + 0.960);
  EXPECT_GT(test::report_s(d.report), kLossS + 49 * 0.016) << "fifty reports cannot be in earlier";
}

TEST(Decision, KeepsTheLoadWhereLessImportantLoadSuffices) {
  const Decision d = decision_with([](Settings& s) { s.accumulated_mw = 200.0F; });
  EXPECT_FALSE(d.shed);
  EXPECT_EQ(d.report.trust, Trust::kTrusted);
  EXPECT_GT(d.report.hits, 20);
}

TEST(Decision, KeepsTheLoadBelowTheThreshold) {
  const Decision d = decision_with([](Settings& s) {
    s.threshold_mw = 600.0F;
    s.accumulated_mw = 0.0F;
  });
  EXPECT_FALSE(d.shed);
  EXPECT_EQ(d.report.required_mw, 0.0F);
  EXPECT_EQ(d.report.trust, Trust::kTrusted);
}

TEST(Decision, TakesMoreHitsOfTheConditionsThanTheSettingsName) {
  const std::uint16_t hits = decision_with([](Settings&) {}).report.hits;
  EXPECT_FALSE(decision_with([hits](Settings& s) { s.condition_hits = hits; }).shed);
  EXPECT_TRUE(decision_with([hits](Settings& s) {
                s.condition_hits = static_cast<std::uint16_t>(hits - 1);
              }).shed);
}

TEST(Decision, KeepsTheLoadOnAnEstimateNotToBeTrusted) {
  const Decision d = decision_with([](Settings& s) { s.trusted_residual_hz = 1e-4F; });
  EXPECT_FALSE(d.shed);
  EXPECT_EQ(d.report.trust, Trust::kResidual);
  EXPECT_GT(d.report.required_mw, 100.0F);
  EXPECT_GT(d.report.hits, 20);
}

TEST(Decision, OfTwoLossesEachIsDecidedOnce) {
  test::MainsSpec spec;
  spec.truth = gsbench::waveform::truth_from_losses(gsbench::grid::SfrModel(test::ieee24()),
                                                    {{1.0, 200.0}, {20.0, 500.0}});
  const Reports reports = test::reports_of(test::Mains(spec), 22.0, test::ieee24_settings());
  EXPECT_EQ(count_of(reports, kEvent), 2);
  EXPECT_EQ(count_of(reports, kDecision), 2);
  EXPECT_EQ(count_of(reports, kRelay), 1);
  EXPECT_FALSE(reports.back().relay_closed);
  EXPECT_TRUE(first_with(reports, kDecision)->relay_closed) << "the first is below the threshold";
}

TEST(Decision, AnEventIsGivenUpWhenTheVoltageGoes) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(500.0, kLossS);
  spec.signal.amplitude_steps = {{kLossS + 0.5, 100.0, 0.0}};
  const Reports reports = test::reports_of(test::Mains(spec), kDurationS, test::ieee24_settings());
  EXPECT_EQ(count_of(reports, kEvent), 1);
  EXPECT_EQ(count_of(reports, kAborted), 1);
  EXPECT_EQ(count_of(reports, kDecision), 0);
  EXPECT_TRUE(reports.back().relay_closed);
  EXPECT_EQ(reports.back().phase, Phase::kQuiet);
}

TEST(Decision, WithoutSettingsItMeasuresAndDecidesNothing) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(2000.0, kLossS);
  const test::Mains mains(spec);
  Config config;
  State state;
  ASSERT_TRUE(configure(mains.hardware(), config));
  int valid = 0;
  test::play(mains, 4.0, config, state, [&](const Report& report) {
    EXPECT_EQ(report.happened, 0);
    EXPECT_TRUE(report.relay_closed);
    valid += report.measurement.validity == Validity::kValid ? 1 : 0;
  });
  EXPECT_GT(valid, 200);
  EXPECT_LT(state.history.frequency_hz[0], 48.5F) << "deep enough to have tripped with settings";
}

TEST(Decision, NewSettingsGiveUpTheEventUnderWay) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(500.0, kLossS);
  const test::Mains mains(spec);
  Config config;
  State state;
  ASSERT_TRUE(configure(mains.hardware(), config));
  Settings settings = test::ieee24_settings();
  ASSERT_EQ(apply(config, state, settings), SettingsError::kNone);
  const std::vector<std::int16_t> samples = mains.samples(0, 8000 * 3);
  bool renewed = false;
  std::vector<std::uint32_t> events;
  std::vector<std::uint32_t> decisions;
  for (std::size_t at = 0; at < samples.size();) {
    Report report;
    bool ready = false;
    at += step(config, state, samples.data() + at, samples.size() - at, report, ready);
    if ((report.happened & kEvent) != 0) events.push_back(report.number);
    if ((report.happened & kDecision) != 0) decisions.push_back(report.number);
    if (!renewed && (report.happened & kLse) != 0) {
      ++settings.version;
      ASSERT_EQ(apply(config, state, settings), SettingsError::kNone);
      EXPECT_EQ(state.phase, Phase::kQuiet);
      renewed = true;
    }
  }
  // The fall goes on, so it is found again and decided once, fifty reports later.
  ASSERT_EQ(events.size(), 2U);
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions[0], events[1] + 49);
}

// State is all there is.
TEST(Outlet, ACopyOfItsStateGoesOnIdentically) {
  test::MainsSpec spec;
  spec.truth = test::loss_of(500.0, 0.5);
  spec.noise_pct = 1.0;
  const test::Mains mains(spec);
  const std::vector<std::int16_t> samples = mains.samples(0, 8000 * 2);
  Config config;
  State state;
  ASSERT_TRUE(configure(mains.hardware(), config));
  ASSERT_EQ(apply(config, state, test::ieee24_settings()), SettingsError::kNone);
  State copy;
  bool copied = false;
  for (std::size_t at = 0; at < samples.size();) {
    if (!copied && at > 5000) {
      copy = state;
      copied = true;
    }
    Report report;
    Report report_of_copy;
    bool ready = false;
    const std::size_t count = std::min<std::size_t>(100, samples.size() - at);
    const std::size_t taken = step(config, state, samples.data() + at, count, report, ready);
    if (copied) {
      bool ready_too = false;
      ASSERT_EQ(step(config, copy, samples.data() + at, count, report_of_copy, ready_too), taken);
      ASSERT_EQ(ready, ready_too);
      ASSERT_EQ(report.happened, report_of_copy.happened);
      ASSERT_EQ(report.loss_mw, report_of_copy.loss_mw);
    }
    at += taken;
  }
  EXPECT_EQ(state.relay_closed, copy.relay_closed);
  EXPECT_EQ(state.tracker.phase_rad, copy.tracker.phase_rad);
}

}  // namespace
}  // namespace gs::outlet
