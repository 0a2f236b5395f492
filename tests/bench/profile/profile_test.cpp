// A plan holds the values of its profile.
#include <profile_test/texts.hpp>

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Profile, HasTheDocumentedDefaults) {
  const Plan plan = parse(kMinimal);
  EXPECT_EQ(plan.seed, 1u);
  EXPECT_EQ(plan.grid.name, "ieee24");
  EXPECT_THAT(plan.stimulus.losses, IsEmpty());
  EXPECT_EQ(plan.stimulus.sample_rate_hz, 8000);
  EXPECT_EQ(plan.stimulus.noise_pct, 0.0);
  EXPECT_THAT(plan.stimulus.signal.harmonics, IsEmpty());
  EXPECT_EQ(plan.stimulus.signal.dc_offset_pct, 0.0);
  ASSERT_THAT(plan.outlets, SizeIs(1));
  EXPECT_EQ(plan.outlets[0].id, "outlet-1");
  EXPECT_EQ(plan.outlets[0].group, "all");
  EXPECT_EQ(plan.outlets[0].settings.accumulated_mw, 0.0);
  EXPECT_TRUE(plan.outlets[0].settings.settings.empty());
  EXPECT_THAT(plan.commands, IsEmpty());
}

TEST(Profile, KeepsItsTextAndDigest) {
  const Plan plan = parse(kMinimal);
  EXPECT_EQ(plan.text, kMinimal);
  EXPECT_EQ(plan.path, "test.toml");
  EXPECT_EQ(plan.name, "test");
  // From coreutils' sha256sum.
  EXPECT_EQ(plan.sha256, "a6b7454ae887c8a32fb06930460c9a746a37d032fe7351c1efaa52a15beadcb3");
}

TEST(Profile, HoldsTitleSourceSeedAndInlineGrid) {
  const Plan plan = parse(kLossesInPlace);
  EXPECT_EQ(plan.title, "Losses in a grid in place");
  EXPECT_EQ(plan.source, "Somewhere");
  EXPECT_EQ(plan.seed, 7u);
  const grid::Grid& grid = plan.grid;
  EXPECT_EQ(grid.title, plan.title);
  EXPECT_EQ(grid.nominal_hz, 60.0);
  EXPECT_EQ(grid.threshold_hz, 59.3);
  EXPECT_EQ(grid.base_mw, 900.0);
  EXPECT_EQ(grid.load_mw, 800.0);
  EXPECT_EQ(grid.damping_pu, 1.5);
  EXPECT_EQ(grid.gain_km, 0.9);
  EXPECT_EQ(grid.reheat_fraction, 0.25);
  EXPECT_EQ(grid.reheat_s, 7.0);
  EXPECT_EQ(grid.condition_row_hz, 0.1);
  EXPECT_EQ(grid.credible_loss_mw, 150.0);
  ASSERT_THAT(grid.plants, SizeIs(2));
  EXPECT_EQ(grid.plants[0].id, "one");
  EXPECT_EQ(grid.plants[0].rating_mw, 500.0);
  EXPECT_EQ(grid.plants[0].inertia_s, 4.0);
  EXPECT_EQ(grid.plants[0].droop_pu, 0.05);
  EXPECT_EQ(grid.plants[1].droop_pu, 0.04);
  ASSERT_THAT(grid.blocks, SizeIs(1));
  EXPECT_EQ(grid.blocks[0].id, "least");
  EXPECT_EQ(grid.blocks[0].power_mw, 30.0);
  EXPECT_EQ(grid.reference.source, "A paper");
  EXPECT_EQ(grid.reference.t_nadir_s, 2.5);
  EXPECT_EQ(grid.reference.threshold_mw, 90.0);
  EXPECT_THAT(grid.reference.condition_rocof_hz_s, ElementsAre(-0.5, 0.0));
  EXPECT_EQ(grid.reference.note, "Why they differ");
}

TEST(Profile, HoldsTones) {
  const std::vector<waveform::Tone> tones = parse(kDisturbed).stimulus.signal.tones;
  ASSERT_THAT(tones, SizeIs(3));
  EXPECT_EQ(tones[0].at_s, 2.5);
  EXPECT_EQ(tones[0].duration_s, 0.5);
  EXPECT_EQ(tones[0].frequency_hz, 216.7);
  EXPECT_EQ(tones[0].amplitude_pct, 9.0);
  EXPECT_EQ(tones[0].phase_deg, -30.0);
  EXPECT_EQ(tones[1].at_s, 0.0);
  EXPECT_EQ(tones[1].duration_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(tones[1].phase_deg, 0.0);
  EXPECT_THAT(parse(kMinimal).stimulus.signal.tones, IsEmpty());
}

TEST(Profile, HoldsThePulsesOfTones) {
  const std::vector<waveform::Tone> tones = parse(kDisturbed).stimulus.signal.tones;
  EXPECT_THAT(tones[0].pulses, IsEmpty());
  ASSERT_THAT(tones[1].pulses, SizeIs(2));  // 1101 0
  EXPECT_EQ(tones[1].pulses[0].from_s, 0.0);
  EXPECT_EQ(tones[1].pulses[0].to_s, 0.2);
  EXPECT_DOUBLE_EQ(tones[1].pulses[1].from_s, 0.3);
  EXPECT_EQ(tones[1].pulses[1].to_s, 0.4);
  ASSERT_THAT(tones[2].pulses, SizeIs(2));
  EXPECT_EQ(tones[2].pulses[1].from_s, 0.75);
  EXPECT_EQ(tones[2].pulses[1].to_s, 1.5);
}

TEST(Profile, HoldsFlicker) {
  const std::vector<waveform::Flicker> flickers = parse(kDisturbed).stimulus.signal.flickers;
  ASSERT_THAT(flickers, SizeIs(2));
  EXPECT_EQ(flickers[0].at_s, 1.0);
  EXPECT_EQ(flickers[0].duration_s, 2.5);
  EXPECT_EQ(flickers[0].frequency_hz, 8.8);
  EXPECT_EQ(flickers[0].depth_pct, 2.0);
  EXPECT_TRUE(flickers[0].rectangular);
  EXPECT_EQ(flickers[1].duration_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(flickers[1].frequency_hz, 8.8);
  EXPECT_FALSE(flickers[1].rectangular);
}

TEST(Profile, HoldsTheFrequencyBeforeAndOscillations) {
  const Stimulus stimulus = parse(kDisturbed).stimulus;
  EXPECT_NEAR(stimulus.initial_deviation_hz, -0.15, 1e-14);
  ASSERT_THAT(stimulus.oscillations, SizeIs(2));
  EXPECT_EQ(stimulus.oscillations[0].at_s, 1.0);
  EXPECT_EQ(stimulus.oscillations[0].duration_s, 8.0);
  EXPECT_EQ(stimulus.oscillations[0].frequency_hz, 0.4);
  EXPECT_EQ(stimulus.oscillations[0].amplitude_hz, 0.06);
  EXPECT_EQ(stimulus.oscillations[0].phase_deg, 90.0);
  EXPECT_EQ(stimulus.oscillations[1].at_s, 0.0);
  EXPECT_EQ(stimulus.oscillations[1].duration_s, std::numeric_limits<double>::infinity());
  EXPECT_EQ(stimulus.oscillations[1].phase_deg, 0.0);
  EXPECT_EQ(parse(kMinimal).stimulus.initial_deviation_hz, 0.0);
  EXPECT_THAT(parse(kMinimal).stimulus.oscillations, IsEmpty());
}

TEST(Profile, HoldsSettingsThatAreSentAgainInOrderOfTimeWithAllChangesSoFar) {
  const std::vector<SettingsUpdate> updates = parse(kDisturbed).settings;
  ASSERT_THAT(updates, SizeIs(3));
  EXPECT_EQ(updates[0].at_s, 3.0);
  EXPECT_THAT(updates[0].outlets, SizeIs(3));
  EXPECT_EQ(updates[0].outlets.at("shed-1").accumulated_mw, 100.0);
  EXPECT_THAT(updates[0].outlets.at("shed-1").settings, IsEmpty());
  EXPECT_EQ(updates[0].changes, "");

  EXPECT_EQ(updates[1].at_s, 6.0);
  ASSERT_THAT(updates[1].outlets, SizeIs(2));
  EXPECT_EQ(updates[1].outlets.at("alone").accumulated_mw, 120.0);
  EXPECT_EQ(updates[1].outlets.at("alone").power_mw, 50.0);
  EXPECT_EQ(updates[1].outlets.at("alone").settings.at("condition_hits"), 12.0);
  EXPECT_EQ(updates[1].changes,
            "accumulated_mw = 120, power_mw = 50, threshold_mw = 300, switch_off_hz = 49.2, "
            "condition_hits = 12, event_drop_hz = 0.03, event_departure_hz = 0.04, "
            "lse_samples = 8, ekf_samples = 30, method = 0, threshold_hz = 49.4, "
            "nadir_margin_hz = 0.01, decision_reports = 50, delay_s = 0.5, restore_hz = 49.9, "
            "restore_dwell_s = 30, restore_spread_s = 100");

  ASSERT_THAT(updates[2].outlets, SizeIs(2));
  EXPECT_EQ(updates[2].outlets.at("shed-1").accumulated_mw, 120.0);
  EXPECT_EQ(updates[2].outlets.at("shed-1").settings.at("threshold_mw"), 250.0);
  EXPECT_EQ(updates[2].outlets.at("shed-1").settings.at("condition_hits"), 12.0);
  EXPECT_EQ(updates[2].outlets.at("shed-2").accumulated_mw, 100.0);
  EXPECT_THAT(updates[2].outlets.at("shed-2").settings, SizeIs(1));
  EXPECT_THAT(parse(kMinimal).settings, IsEmpty());
}

TEST(Profile, RefusesSettingsThatAreSentTooOften) {
  std::string text;
  for (int i = 0; i < 101; ++i) {
    text += "[[settings]]\nat_s = 1.0\n";
  }
  EXPECT_EQ(refusal(replaced(kMinimal, "[[expect]]", text + "[[expect]]")),
            "test.toml:208:1: settings are sent 101 times; a profile sends them at most 100 times");
  EXPECT_EQ(refusal(replaced(kMinimal, "[[expect]]", text.substr(24) + "[[expect]]")), "");
}

TEST(Profile, HoldsLossesAtOnceAndOverATime) {
  const Stimulus stimulus = parse(kDisturbed).stimulus;
  ASSERT_THAT(stimulus.losses, SizeIs(2));
  EXPECT_EQ(stimulus.losses[0].ramp_s, 3.0);
  EXPECT_EQ(stimulus.losses[1].at_s, 4.5);
  EXPECT_EQ(stimulus.losses[1].ramp_s, 0.0);
}

TEST(Profile, HoldsTheSignalWithLossesSortedByTime) {
  const Stimulus stimulus = parse(kLossesInPlace).stimulus;
  EXPECT_EQ(stimulus.duration_s, 10.0);
  EXPECT_EQ(stimulus.sample_rate_hz, 4000);
  EXPECT_EQ(stimulus.noise_pct, 0.5);
  ASSERT_THAT(stimulus.losses, SizeIs(2));
  EXPECT_EQ(stimulus.losses[0].at_s, 2.0);
  EXPECT_EQ(stimulus.losses[0].power_mw, 100.0);
  EXPECT_EQ(stimulus.losses[1].power_mw, -50.0);
  const waveform::SignalSpec& signal = stimulus.signal;
  EXPECT_EQ(signal.dc_offset_pct, 0.25);
  EXPECT_EQ(signal.initial_phase_deg, 30.0);
  ASSERT_THAT(signal.amplitude_steps, SizeIs(2));
  EXPECT_EQ(signal.amplitude_steps[0].at_s, 5.0);
  EXPECT_EQ(signal.amplitude_steps[0].duration_s, 1.5);
  EXPECT_EQ(signal.amplitude_steps[0].level_pct, 40.0);
  EXPECT_EQ(signal.amplitude_steps[1].duration_s, std::numeric_limits<double>::infinity());
  ASSERT_THAT(signal.phase_jumps, SizeIs(1));
  EXPECT_EQ(signal.phase_jumps[0].at_s, 3.0);
  EXPECT_EQ(signal.phase_jumps[0].degrees, -20.0);
}

TEST(Profile, AddsListedHarmonicsToTheEn50160Set) {
  const auto harmonics = parse(kLossesInPlace).stimulus.signal.harmonics;
  ASSERT_THAT(harmonics, SizeIs(24 + 2));  // EN 50160 limits orders 2 … 25
  EXPECT_EQ(harmonics[24].order, 26);
  EXPECT_EQ(harmonics[24].amplitude_pct, 5.0);
  EXPECT_EQ(harmonics[24].phase_deg, 90.0);
  EXPECT_EQ(harmonics[25].phase_deg, -10.0);
}

TEST(Profile, HasEachHarmonicOfTheEn50160SetAtItsLimit) {
  const auto harmonics = parse(kLossesInPlace).stimulus.signal.harmonics;
  double squares = 0.0;
  for (int i = 0; i < 24; ++i) {
    const waveform::Harmonic& harmonic = harmonics[static_cast<std::size_t>(i)];
    EXPECT_EQ(harmonic.order, i + 2);
    squares += harmonic.amplitude_pct * harmonic.amplitude_pct;
  }
  EXPECT_EQ(harmonics[5 - 2].amplitude_pct, 6.0);
  EXPECT_EQ(harmonics[24 - 2].amplitude_pct, 0.5);
  // Root of the sum of squares of the standard's limits, by hand: √128.25.
  EXPECT_NEAR(std::sqrt(squares), 11.325, 5e-4);
}

TEST(Profile, NamesAndNumbersItsOutlets) {
  const Plan plan = parse(kLossesInPlace);
  std::vector<std::string> ids;
  std::vector<std::string> groups;
  for (const Outlet& outlet : plan.outlets) {
    ids.push_back(outlet.id);
    groups.push_back(outlet.group);
  }
  EXPECT_THAT(ids, ElementsAre("shed-1", "shed-2", "shed-3", "alone", "outlet-5", "outlet-6"));
  EXPECT_THAT(groups, ElementsAre("early", "early", "early", "alone", "all", "all"));
}

TEST(Profile, GivesEachOutletItsSettings) {
  const Plan plan = parse(kLossesInPlace);
  const control_centre::RequestedSettings& settings = plan.outlets[2].settings;
  EXPECT_EQ(settings.accumulated_mw, 100.0);
  EXPECT_EQ(settings.power_mw, 40.0);
  EXPECT_EQ(settings.settings, (std::map<std::string, double>{{"threshold_mw", 200.0},
                                                              {"switch_off_hz", 58.5},
                                                              {"event_drop_hz", 0.03},
                                                              {"event_departure_hz", 0.04},
                                                              {"condition_hits", 12.0},
                                                              {"lse_samples", 8.0},
                                                              {"ekf_samples", 30.0}}));
  EXPECT_TRUE(plan.outlets[3].settings.settings.empty());
}

TEST(Profile, GivesEachOutletTheRulesOfItsSettings) {
  EXPECT_EQ(parse(kMinimal).outlets[0].settings.rules, control_centre::Rules::kGsbench);
  EXPECT_EQ(parse(kPoints).outlets[0].settings.rules, control_centre::Rules::kPaper);
}

TEST(Profile, SortsCommandsByTimeAndResolvesGroups) {
  const auto commands = parse(kLossesInPlace).commands;
  ASSERT_THAT(commands, SizeIs(2));
  EXPECT_EQ(commands[0].at_s, 6.0);
  EXPECT_FALSE(commands[0].switch_on);
  EXPECT_THAT(commands[0].outlets, IsEmpty());  // all
  EXPECT_TRUE(commands[1].switch_on);
  EXPECT_THAT(commands[1].outlets, ElementsAre("shed-1", "shed-2", "shed-3", "alone"));
}

TEST(Profile, KeepsTheGivenUnitOfLimits) {
  const auto expectations = parse(kLossesInPlace).expectations;
  ASSERT_THAT(expectations, SizeIs(2));
  EXPECT_EQ(expectations[0].measure, "event.delay");
  EXPECT_EQ(expectations[0].unit, "s");  // the catalogue has ms
  EXPECT_EQ(expectations[0].min, 0.03);
  EXPECT_EQ(expectations[0].max, 0.16);
  EXPECT_THAT(expectations[0].groups, ElementsAre("early"));
  EXPECT_EQ(expectations[0].line, 83);
  EXPECT_EQ(expectations[1].equals, "open");
  EXPECT_FALSE(expectations[1].min);
  EXPECT_THAT(expectations[1].groups, IsEmpty());
}

TEST(Profile, HoldsFrequencyPoints) {
  const Stimulus stimulus = parse(kPoints).stimulus;
  EXPECT_EQ(stimulus.tolerances.frequency_mhz, 0.2);
  EXPECT_EQ(stimulus.tolerances.voltage_pct, 0.5);
  EXPECT_EQ(stimulus.tolerances.time_ms, 0.1);
  ASSERT_THAT(stimulus.points, SizeIs(3));
  EXPECT_EQ(stimulus.points[1].t_s, 2.0);
  EXPECT_EQ(stimulus.points[1].frequency_hz, 49.5);
  EXPECT_EQ(stimulus.recording.path, "");
  EXPECT_TRUE(stimulus.losses.empty());
}

TEST(Profile, TakesTheSeedFromTheCommandLineIfGiven) {
  Overrides overrides;
  overrides.seed = 42;
  EXPECT_EQ(parse_profile(kLossesInPlace, "test.toml", overrides).seed, 42u);
}

TEST(Profile, ReadsWindowsLineEndsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : std::string(kMinimal)) {
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(parse(text).title, "A test");
}

}  // namespace
}  // namespace gsbench::profile::test
