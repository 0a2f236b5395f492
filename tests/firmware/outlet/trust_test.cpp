// The rating of an estimate: trusted, or not, and why.
#include <firmware_test/settings.hpp>

#include <functional>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>
#include <outlet/estimator.hpp>

namespace gs::outlet {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kNominal_hz = 50.0F;
constexpr Line kNoLine = {kNoNumber, kNoNumber};

// Deviation in Hz, by the time after the event in s.
using Deviation = std::function<double(double)>;

// A loss 80 ms before the event: the time of five drops.
Deviation loss_of(double power_mw) {
  const gsbench::grid::SfrModel model(test::ieee24());
  return [model, power_mw](double t_s) { return power_mw * model.unit_deviation_hz(t_s + 0.08); };
}

struct Played {
  Settings settings = test::ieee24_settings();
  EstimatorState state;
};

Played play(const Deviation& deviation, float rocof_before_hz_s = 0.0F, int reports = 50) {
  Played played;
  begin(played.state, {kNominal_hz, rocof_before_hz_s});
  for (int k = 0; k < reports; ++k) {
    const auto frequency_hz = static_cast<float>(50.0 + deviation(0.016 * k));
    observe(played.settings, kNominal_hz, played.state, true, frequency_hz, kNoLine);
  }
  return played;
}

Trust trust_of(const Played& played) {
  return trust(played.settings, played.state);
}

TEST(Trust, ANoiseFreeLossIsTrustedAndAccurate) {
  const Played played = play(loss_of(500.0));
  EXPECT_EQ(trust_of(played), Trust::kTrusted);
  EXPECT_TRUE(complete(played.settings, played.state));
  // 0.5 %: far below the paper's 4 %. The rest is due to the LSE's start and σ = 5 mHz.
  EXPECT_NEAR(played.state.ekf.loss_mw, 500.0F, 2.5F);
  EXPECT_NEAR(loss_instant_s(played.state), -0.08F - kFrontEndDelay_s, 3e-3F);
}

TEST(Trust, NothingIsTrustedBeforeHalfOfTheReports) {
  for (const int reports : {0, 1, 9, 10, 29}) {
    const Played played = play(loss_of(500.0), 0.0F, reports);
    EXPECT_EQ(trust_of(played), Trust::kNotYet) << reports;
    EXPECT_FALSE(complete(played.settings, played.state));
  }
  EXPECT_EQ(trust_of(play(loss_of(500.0), 0.0F, 30)), Trust::kTrusted);
}

TEST(Trust, AFrequencyThatMovedBeforeTheEventIsNotTrusted) {
  EXPECT_EQ(trust_of(play(loss_of(500.0), -0.2F)), Trust::kUnsteadyStart);
  EXPECT_EQ(trust_of(play(loss_of(500.0), 0.2F)), Trust::kUnsteadyStart);
  EXPECT_EQ(trust_of(play(loss_of(500.0), kNoNumber)), Trust::kUnsteadyStart);
  EXPECT_EQ(trust_of(play(loss_of(500.0), 0.05F)), Trust::kTrusted);
}

// A second loss, which the model of a single loss cannot follow.
TEST(Trust, MeasurementsThatDoNotFollowTheModelAreNotTrusted) {
  const Deviation first = loss_of(300.0);
  const Deviation second = loss_of(1500.0);
  const Played played =
      play([&](double t_s) { return first(t_s) + (t_s > 0.4 ? second(t_s - 0.48) : 0.0); });
  EXPECT_EQ(trust_of(played), Trust::kResidual);
}

TEST(Trust, AnInfiniteMeasurementIsNotTrusted) {
  for (const float odd : {kNoNumber, std::numeric_limits<float>::infinity()}) {
    Played played = play(loss_of(500.0), 0.0F, 40);
    observe(played.settings, kNominal_hz, played.state, true, odd, kNoLine);
    EXPECT_NE(trust_of(played), Trust::kTrusted);
  }
}

TEST(Trust, TheEstimateOfALossAboveTheLargestIsAtItsUpperBound) {
  EXPECT_EQ(trust_of(play(loss_of(4000.0))), Trust::kAtBound);
}

TEST(Trust, TheEstimateForARisingFrequencyIsAtItsLowerBound) {
  EXPECT_EQ(trust_of(play(loss_of(-500.0))), Trust::kAtBound);
}

TEST(Trust, ALossBelowTheNoiseIsTooUncertain) {
  EXPECT_EQ(trust_of(play(loss_of(5.0))), Trust::kUncertain);
}

TEST(Estimator, AGapDuringTheLseRestartsIt) {
  Played played = play(loss_of(500.0), 0.0F, 9);
  EXPECT_EQ(played.state.lse.count, 9);
  observe(played.settings, kNominal_hz, played.state, false, kNoNumber, kNoLine);
  EXPECT_EQ(played.state.lse.count, 0);
  EXPECT_FALSE(played.state.started);
}

TEST(Estimator, TheEkfContinuesAfterAGapAtTheRightTime) {
  const Deviation deviation = loss_of(500.0);
  Played played = play(deviation, 0.0F, 20);
  for (int k = 20; k < 50; ++k) {
    const bool valid = k < 25 || k >= 30;
    const auto frequency_hz = valid ? static_cast<float>(50.0 + deviation(0.016 * k)) : kNoNumber;
    observe(played.settings, kNominal_hz, played.state, valid, frequency_hz, kNoLine);
  }
  EXPECT_EQ(played.state.ekf.count, 35);
  EXPECT_EQ(trust_of(played), Trust::kTrusted);
  EXPECT_NEAR(played.state.ekf.loss_mw, 500.0F, 2.5F);
}

TEST(Estimator, ConditionsCountAfterTheLse) {
  Played played;
  begin(played.state, {kNominal_hz, 0.0F});
  const Line falling = {49.95F, -2.0F};
  for (int k = 0; k < 50; ++k) {
    observe(played.settings, kNominal_hz, played.state, true, 49.9F, falling);
    EXPECT_EQ(played.state.hits, std::max(0, k + 1 - 10)) << k;
  }
  EXPECT_EQ(played.state.hits, played.settings.ekf_samples);
}

TEST(Trust, EachStatusHasItsOwnText) {
  std::set<std::string> words;
  for (const Trust trust : {Trust::kTrusted, Trust::kNotYet, Trust::kUnsteadyStart,
                            Trust::kResidual, Trust::kAtBound, Trust::kUncertain}) {
    words.insert(to_string(trust));
  }
  EXPECT_EQ(words.size(), 6U);
}

}  // namespace
}  // namespace gs::outlet
