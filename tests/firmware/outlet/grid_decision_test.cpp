// Decisions by the grid's state: losses one after another, ramps, returns, disturbances of the
// voltage, an oscillation beneath. A scenario is right if an outlet with a small P^A sheds, one
// with a large P^A does not, and the lost power is known at the decision.
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <gtest/gtest.h>

#include <outlet/outlet.hpp>
#include <waveform/oscillation.hpp>

namespace gs::outlet {
namespace {

using gsbench::grid::PowerChange;

struct Scenario {
  const char* name;
  std::vector<PowerChange> losses;
  double duration_s;
  float sheds_up_to_mw;  // P^A of an outlet that must shed; 0: none may
  float stays_from_mw;   // P^A of one that must not
  double lost_mw = 0.0;  // at the last decision; 0: not compared
  gsbench::waveform::SignalSpec signal = {};
  gsbench::waveform::Oscillation oscillation = {};
};

gsbench::waveform::Oscillation oscillation(double at_s, double frequency_hz, double amplitude_hz,
                                           double phase_deg = 0.0) {
  gsbench::waveform::Oscillation swing;
  swing.at_s = at_s;
  swing.frequency_hz = frequency_hz;
  swing.amplitude_hz = amplitude_hz;
  swing.phase_deg = phase_deg;
  return swing;
}

Scenario within(const gsbench::waveform::Oscillation& oscillation, Scenario scenario) {
  scenario.oscillation = oscillation;
  return scenario;
}

gsbench::waveform::SignalSpec dip(double at_s, double duration_s, double level_pct) {
  gsbench::waveform::SignalSpec signal;
  signal.amplitude_steps = {{at_s, duration_s, level_pct}};
  return signal;
}

std::vector<PowerChange> ramped(double at_s, double ramp_s, double power_mw) {
  std::vector<PowerChange> steps;
  constexpr int kSteps = 200;
  steps.reserve(kSteps);
  for (int i = 0; i < kSteps; ++i) {
    steps.push_back({at_s + ramp_s * (i + 0.5) / kSteps, power_mw / kSteps});
  }
  return steps;
}

const Scenario kScenarios[] = {
    {"OneLoss", {{3.0, 500.0}}, 6.0, 145.0F, 170.0F, 500.0},
    {"BelowTheThreshold", {{3.0, 330.0}}, 8.0, 0.0F, 1.0F},
    {"TwoHalves", {{3.0, 300.0}, {3.5, 300.0}}, 7.0, 250.0F, 330.0F, 600.0},
    {"SecondAfterTwoSeconds", {{3.0, 250.0}, {5.0, 350.0}}, 8.0, 200.0F, 330.0F, 600.0},
    {"ThreeInARow", {{3.0, 200.0}, {4.0, 200.0}, {5.0, 200.0}}, 9.0, 190.0F, 330.0F, 600.0},
    {"NeighbouringLosses", {{3.0, 400.0}, {3.3, 200.0}}, 7.0, 245.0F, 350.0F, 600.0},
    // What was required in the ramp is not shed here and is counted once more after it.
    {"RampOfOneSecond", ramped(3.0, 1.0, 500.0), 8.0, 140.0F, 250.0F},
    {"RampOfThreeSeconds", ramped(3.0, 3.0, 500.0), 10.0, 90.0F, 250.0F},
    {"LowFrequencyBefore", {{-200.0, 191.5}, {3.0, 300.0}}, 8.0, 45.0F, 75.0F},
    {"ReturnsAtOnce", {{3.0, 500.0}, {3.3, -500.0}}, 7.0, 0.0F, 1.0F},
    {"DipWithTheLoss", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(3.0, 0.07, 85.0)},
    {"DipWhileEstimating", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(3.3, 0.15, 40.0)},
    {"InterruptionWithTheLoss", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(3.0, 0.1, 0.0)},
    {"InterruptionWhileEstimating", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(3.3, 0.2, 0.0)},
    {"LossAfterAnInterruption", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(2.4, 0.2, 0.0)},
    {"LossAfterADip", {{3.0, 600.0}}, 7.0, 240.0F, 330.0F, 600.0, dip(2.53, 0.07, 40.0)},
    within(oscillation(0.0, 0.4, 0.06), {"Oscillation", {}, 8.0, 0.0F, 1.0F}),
    within(oscillation(0.0, 0.4, 0.06),
           {"LossInAnOscillation", {{7.0, 500.0}}, 10.0, 130.0F, 200.0F}),
    within(oscillation(0.0, 0.25, 0.06),
           {"LossInASlowOscillation", {{8.0, 500.0}}, 11.0, 130.0F, 200.0F}),
    within(oscillation(0.0, 0.8, 0.04),
           {"LossInAFastOscillation", {{7.0, 500.0}}, 10.0, 130.0F, 200.0F}),
    within(oscillation(3.0, 0.5, 0.06), {"OscillationThatStarts", {}, 12.0, 0.0F, 1.0F}),
    within(oscillation(3.0, 0.3, 0.05, 90.0),
           {"OscillationThatStartsWithAStep", {}, 12.0, 0.0F, 1.0F}),
    within(oscillation(3.5, 0.6, 0.04),
           {"LossAfterAnOscillationStarted", {{5.0, 500.0}}, 8.0, 130.0F, 200.0F, 500.0}),
    within(oscillation(4.0, 0.7, 0.04, 180.0),
           {"LossAfterAnOscillationStartedWithAStep", {{5.0, 500.0}}, 8.0, 130.0F, 200.0F, 500.0}),
};

void PrintTo(const Scenario& scenario, std::ostream* out) {
  *out << scenario.name;
}

class GridDecision : public testing::TestWithParam<Scenario> {
 protected:
  std::vector<Report> reports_with(float accumulated_mw, std::uint64_t seed) const {
    const Scenario& scenario = GetParam();
    Settings settings = test::ieee24_settings();
    settings.accumulated_mw = accumulated_mw;
    settings.switch_off_hz = 45.0F;
    test::MainsSpec mains;
    mains.reference = gsbench::waveform::with_oscillations(
        gsbench::waveform::reference_from_losses(gsbench::grid::SfrModel(test::ieee24()),
                                                 scenario.losses),
        {scenario.oscillation});
    mains.signal = scenario.signal;
    mains.noise_pct = 1.0;
    mains.seed = seed;
    return test::reports_of(mains, scenario.duration_s, settings);
  }
};

INSTANTIATE_TEST_SUITE_P(Of, GridDecision, testing::ValuesIn(kScenarios),
                         [](const auto& scenario) { return std::string(scenario.param.name); });

TEST_P(GridDecision, IsRightForOutletsOnBothSidesOfWhatIsRequired) {
  const Scenario& scenario = GetParam();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    if (scenario.sheds_up_to_mw > 0.0F) {
      const std::vector<Report> reports = reports_with(scenario.sheds_up_to_mw, seed);
      EXPECT_FALSE(reports.back().relay_closed) << seed;
      EXPECT_EQ(reports.back().cause, Cause::kLoss) << seed;
    }
    const std::vector<Report> reports = reports_with(scenario.stays_from_mw, seed);
    EXPECT_TRUE(reports.back().relay_closed) << seed;
    bool decided = false;
    for (const Report& report : reports) {
      if ((report.happened & kDecision) != 0 && scenario.lost_mw > 0.0 &&
          test::report_s(report) > scenario.losses.back().at_s + 0.5) {
        EXPECT_NEAR(static_cast<double>(report.loss_mw), scenario.lost_mw, 0.04 * scenario.lost_mw)
            << seed;
        EXPECT_TRUE(decided || test::report_s(report) <= scenario.losses.back().at_s + 1.2) << seed;
        decided = true;
      }
    }
  }
}

// What others shed is seen as a smaller loss, and nothing more is required.
TEST(GridDecisions, CountWhatWasShedBefore) {
  Settings settings = test::ieee24_settings();
  settings.accumulated_mw = 300.0F;
  const std::vector<Report> reports = test::reports_of(
      {gsbench::waveform::reference_from_losses(gsbench::grid::SfrModel(test::ieee24()),
                                                {{3.0, 500.0}, {3.8, -158.0}, {8.0, 350.0}}),
       {},
       1.0},
      11.0, settings);
  std::vector<Report> decisions;
  for (const Report& report : reports) {
    if ((report.happened & kDecision) != 0) {
      decisions.push_back(report);
    }
  }
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].shed_before_mw, 0.0F);
  EXPECT_NEAR(decisions[0].required_mw, 157.0F, 10.0F);
  EXPECT_FALSE(decisions[0].shed);
  EXPECT_EQ(decisions[1].shed_before_mw, decisions[0].required_mw);
  EXPECT_GT(decisions[1].required_mw, 150.0F);
  EXPECT_TRUE(decisions[1].shed) << "both together are more than P^A";
}

// A loss soon after the start of the outlet, and around an interruption from 2.8 to 3.0 s: the
// history of frequencies is then shorter than the baseline.
TEST(GridDecisions, ReportTheFrequencyBeforeALossWhileTheHistoryIsShort) {
  std::vector<double> instants;
  for (int step = 0; step <= 40; ++step) {
    instants.push_back(step <= 15 ? 0.3 + 0.05 * step : 2.7 + 0.02 * (step - 15));
  }
  for (const double at_s : instants) {
    test::MainsSpec mains;
    mains.reference = gsbench::waveform::reference_from_losses(
        gsbench::grid::SfrModel(test::ieee24()), {{at_s, 600.0}});
    mains.signal = dip(2.8, 0.2, 0.0);
    mains.noise_pct = 1.0;
    int events = 0;
    for (const Report& report : test::reports_of(mains, at_s + 0.8, test::ieee24_settings())) {
      if ((report.happened & kEvent) != 0) {
        ++events;
        EXPECT_NEAR(report.baseline.frequency_hz, 50.0F, 0.01F) << at_s;
        EXPECT_NEAR(report.baseline.rocof_hz_s, 0.0F, 0.1F) << at_s;
      }
    }
    EXPECT_EQ(events, 1) << at_s;
  }
}

TEST(GridDecisions, NewSettingsInAQuietGridClearWhatWasShedBefore) {
  for (const Phase phase : {Phase::kQuiet, Phase::kCooling}) {
    Config config;
    State state;
    ASSERT_TRUE(configure(Hardware{}, config));
    Settings settings = test::ieee24_settings();
    ASSERT_EQ(apply(config, state, settings), SettingsError::kNone);
    state.account.shed_mw = 150.0F;
    state.phase = phase;
    settings.version = 2;
    ASSERT_EQ(apply(config, state, settings), SettingsError::kNone);
    EXPECT_EQ(state.account.shed_mw, phase == Phase::kQuiet ? 0.0F : 150.0F);
  }
}

}  // namespace
}  // namespace gs::outlet
